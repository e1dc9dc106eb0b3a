#include "ui/window/page_stack.h"

#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace vybeg::ui {

WelcomePage::WelcomePage(QWidget* parent)
    : QWidget(parent),
      opened_(withName(new QLabel(this), "opened")),
      text_(new QLabel(this)),
      open_(new QPushButton(this)),
      demonstration_(withName(new QPushButton(this), "demonstration")),
      recent_name_(new QLabel(this)),
      recent_(withName(new QListWidget(this), "recent")) {
    text_->setAlignment(Qt::AlignCenter);
    text_->setWordWrap(true);
    makeSentence(*opened_);
    opened_->setAlignment(Qt::AlignCenter);
    opened_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    recent_->setMaximumWidth(640);
    recent_->setAlternatingRowColors(true);
    recent_->setTextElideMode(Qt::ElideMiddle);
    recent_name_->setBuddy(recent_);
    auto* buttons = fill(new QHBoxLayout, {LayoutPart(1), open_, demonstration_, LayoutPart(1)});
    auto* files = fill(new QVBoxLayout, {recent_name_, {recent_, 1}});
    auto* middle = fill(new QHBoxLayout, {LayoutPart(1), {files, 4}, LayoutPart(1)});
    auto* layout = fill(new QVBoxLayout(this), {LayoutPart(2), opened_, text_});
    layout->addSpacing(12);
    layout->addLayout(buttons);
    layout->addSpacing(18);
    layout->addLayout(middle, 4);
    layout->addStretch(1);
    connect(opened_, &QLabel::linkActivated, this, [this](const QString& word) {
        if (const auto page = pageOfWord(word)) {
            emit pageWanted(*page);
        }
    });
    connect(open_, &QPushButton::clicked, this, &WelcomePage::openWanted);
    connect(demonstration_, &QPushButton::clicked, this, &WelcomePage::demonstrationWanted);
    connect(recent_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        emit recentChosen(item->data(Qt::UserRole).toString());
    });
    connect(recent_, &QListWidget::itemClicked, recent_, &QListWidget::itemActivated);
    setRecent({});
    setOpened({});
    keepTranslated(*this, [this] { retranslate(); });
}

void WelcomePage::setRecent(const QStringList& paths) {
    recent_->clear();
    for (const QString& path : paths) {
        const QFileInfo file(path);
        auto* item = new QListWidgetItem(
            QStringLiteral("%1\n%2").arg(file.fileName(), QDir::toNativeSeparators(file.path())),
            recent_);
        item->setData(Qt::UserRole, path);
        item->setToolTip(plainTip(QDir::toNativeSeparators(path)));
    }
    recent_name_->setVisible(!paths.isEmpty());
    recent_->setVisible(!paths.isEmpty());
}

void WelcomePage::setOpened(const QString& text) {
    opened_->setText(text);
    opened_->setVisible(!text.isEmpty());
}

void WelcomePage::retranslate() {
    text_->setText(
        tr("<p style='font-size:large'>Drop a recording of a free decay here</p>"
           "<p>Two channels, C and D: WAV, FLAC, CSV and other tables of numbers</p>"));
    open_->setText(tr("Open recording…"));
    open_->setToolTip(tr("A recording of a free decay, or a session"));
    demonstration_->setText(tr("Open the demonstration"));
    demonstration_->setToolTip(
        tr("A simulated free decay: 28 s, 5300 Hz, with a frequency split, a decay and noise"));
    recent_name_->setText(tr("Recent files"));
    setWords(*recent_, tr("Recent files"), tr("A click or Return opens a file"));
}

namespace {

// What a page shows.
enum class About { recordings, sets, other };

struct PageRow {
    const char* word;
    const char* title;  // of context "Pages"
    PageNeeds needs;
    About about = About::recordings;
};

// As Page.
constexpr std::array page_rows{
    PageRow{"tracks",
            QT_TRANSLATE_NOOP("Pages", "Tracks"),
            {.sidebar = true, .ledger = true, .overview = true, .wave = true}},
    PageRow{"signals",
            QT_TRANSLATE_NOOP("Pages", "Signals"),
            {.sidebar = true, .ledger = true, .overview = true, .wave = true}},
    PageRow{
        "residuals", QT_TRANSLATE_NOOP("Pages", "Residuals"), {.sidebar = true, .ledger = true}},
    PageRow{"windows", QT_TRANSLATE_NOOP("Pages", "Windows"), {.sidebar = true, .ledger = true}},
    PageRow{"resonator", QT_TRANSLATE_NOOP("Pages", "Resonator"), {}, About::sets},
    PageRow{"drift", QT_TRANSLATE_NOOP("Pages", "Drift"), {}, About::other},
    PageRow{"history", QT_TRANSLATE_NOOP("Pages", "History"), {}, About::other},
};
static_assert(page_rows.size() == static_cast<std::size_t>(Page::history) + 1);

const PageRow& rowOf(Page page) {
    return page_rows.at(static_cast<std::size_t>(page));
}

}  // namespace

QString pageWord(Page page) {
    return QLatin1String(rowOf(page).word);
}

std::optional<Page> pageOfWord(const QString& word) {
    const auto found = std::ranges::find_if(
        page_rows, [&word](const PageRow& row) { return word == QLatin1String(row.word); });
    return found == page_rows.end() ? std::nullopt
                                    : std::optional(static_cast<Page>(found - page_rows.begin()));
}

QString pageTitle(Page page) {
    return QCoreApplication::translate("Pages", rowOf(page).title);
}

PageStack::PageStack(QWidget* welcome, QWidget* parent)
    : QWidget(parent),
      tabs_(withName(new QTabBar(this), "pages")),
      stack_(new QStackedWidget(this)) {
    tabs_->setDocumentMode(true);
    tabs_->setExpanding(false);
    tabs_->setDrawBase(false);
    tabs_->setUsesScrollButtons(false);
    stack_->addWidget(welcome);
    fill(new QVBoxLayout(this), {}, 0, {LayoutPart(stack_, 1)});
    connect(tabs_, &QTabBar::currentChanged, this, &PageStack::showTab);
    showTab();
    keepTranslated(*this, [this] { retranslate(); });
}

void PageStack::add(QWidget* page) {
    stack_->addWidget(page);
    tabs_->addTab(QString());
    retranslate();
}

void PageStack::setOpen(const OpenThings& open) {
    if (open != open_) {
        open_ = open;
        showTab();
    }
}

void PageStack::showPage(Page page) {
    tabs_->setCurrentIndex(static_cast<int>(page));
}

// Before a page is added, the first.
Page PageStack::page() const {
    return static_cast<Page>(std::max(tabs_->currentIndex(), 0));
}

bool PageStack::welcomes() const {
    const bool has_tracks = page() == Page::tracks && open_.tracks;
    return isEmpty() && !has_tracks;
}

// Whether the page is about something of which nothing is open.
bool PageStack::isEmpty() const {
    const About about = rowOf(page()).about;
    return about != About::other && !open_.recordings && !(about == About::sets && open_.sets);
}

PageNeeds PageStack::needs() const {
    const PageNeeds& needs = rowOf(page()).needs;
    return isEmpty() ? PageNeeds{.sidebar = needs.sidebar && open_.sets} : needs;
}

// Page 0 of the stack is the welcome.
void PageStack::showTab() {
    tabs_->setVisible(!welcomes() || open_.sets || open_.angle_logs);
    stack_->setCurrentIndex(welcomes() ? 0 : tabs_->currentIndex() + 1);
    emit pageShown();
}

void PageStack::retranslate() {
    for (int tab = 0; tab < tabs_->count(); ++tab) {
        tabs_->setTabText(tab, pageTitle(static_cast<Page>(tab)));
        tabs_->setTabToolTip(tab, QKeySequence(QKeyCombination(Qt::CTRL, Qt::Key(Qt::Key_1 + tab)))
                                      .toString(QKeySequence::NativeText));
    }
    tabs_->setAccessibleName(tr("Pages"));
}

}  // namespace vybeg::ui

#include "moc_page_stack.cpp"
