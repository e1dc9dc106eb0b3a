#include "ui/window/page_stack.h"

#include "ui/widgets/page_parts.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace vybeg::ui {

namespace {

struct PageRow {
    const char* word;
    const char* title;  // of context "Pages"
    PageNeeds needs;
    bool of_recordings = true;  // without one the welcome stands in its place
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
    PageRow{"resonator", QT_TRANSLATE_NOOP("Pages", "Resonator"), {}},
    PageRow{"drift", QT_TRANSLATE_NOOP("Pages", "Drift"), {}, false},
    PageRow{"history", QT_TRANSLATE_NOOP("Pages", "History"), {}, false},
};
static_assert(page_rows.size() == static_cast<std::size_t>(Page::history) + 1);

const PageRow& rowOf(Page page) {
    return page_rows.at(static_cast<std::size_t>(page));
}

}  // namespace

PageNeeds needsOf(Page page) {
    return rowOf(page).needs;
}

QString pageWord(Page page) {
    return QLatin1String(rowOf(page).word);
}

std::optional<Page> pageOfWord(const QString& word) {
    const auto found = std::ranges::find_if(
        page_rows, [&word](const PageRow& row) { return word == QLatin1String(row.word); });
    return found == page_rows.end() ? std::nullopt
                                    : std::optional(static_cast<Page>(found - page_rows.begin()));
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

void PageStack::setWelcome(bool shown) {
    if (welcome_ != shown) {
        welcome_ = shown;
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
    return welcome_ && rowOf(page()).of_recordings;
}

PageNeeds PageStack::needs() const {
    return welcomes() ? PageNeeds() : needsOf(page());
}

// Page 0 of the stack is the welcome.
void PageStack::showTab() {
    tabs_->setVisible(!welcomes());
    stack_->setCurrentIndex(welcomes() ? 0 : tabs_->currentIndex() + 1);
    emit pageShown();
}

void PageStack::retranslate() {
    for (int tab = 0; tab < tabs_->count(); ++tab) {
        tabs_->setTabText(
            tab, QCoreApplication::translate("Pages", rowOf(static_cast<Page>(tab)).title));
        tabs_->setTabToolTip(tab, QKeySequence(QKeyCombination(Qt::CTRL, Qt::Key(Qt::Key_1 + tab)))
                                      .toString(QKeySequence::NativeText));
    }
    tabs_->setAccessibleName(tr("Pages"));
}

}  // namespace vybeg::ui
