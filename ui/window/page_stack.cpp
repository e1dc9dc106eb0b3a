#include "ui/window/page_stack.h"

#include <QCoreApplication>
#include <QEvent>
#include <QKeySequence>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace vybeg::ui {

namespace {

// As Page.
constexpr std::array page_words{"tracks",  "signals",   "residuals",
                                "windows", "resonator", "history"};
static_assert(page_words.size() == static_cast<std::size_t>(Page::history) + 1);

}  // namespace

QString pageWord(Page page) {
    return QLatin1String(page_words.at(static_cast<std::size_t>(page)));
}

std::optional<Page> pageOfWord(const QString& word) {
    const auto found = std::ranges::find_if(
        page_words, [&word](const char* each) { return word == QLatin1String(each); });
    return found == page_words.end() ? std::nullopt
                                     : std::optional(static_cast<Page>(found - page_words.begin()));
}

PageStack::PageStack(QWidget* welcome, QWidget* parent)
    : QWidget(parent), tabs_(new QTabBar(this)), stack_(new QStackedWidget(this)) {
    tabs_->setObjectName(QStringLiteral("pages"));
    tabs_->setDocumentMode(true);
    tabs_->setExpanding(false);
    tabs_->setDrawBase(false);
    tabs_->setUsesScrollButtons(false);
    stack_->addWidget(welcome);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(stack_, 1);
    connect(tabs_, &QTabBar::currentChanged, this, &PageStack::showTab);
    showTab();
}

void PageStack::add(QWidget* page, const char* title) {
    titles_ << title;
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

Page PageStack::page() const {
    return static_cast<Page>(tabs_->currentIndex());
}

bool PageStack::welcomes() const {
    return welcome_ && page() != Page::history;
}

// Page 0 of the stack is the welcome.
void PageStack::showTab() {
    tabs_->setVisible(!welcomes());
    stack_->setCurrentIndex(welcomes() ? 0 : tabs_->currentIndex() + 1);
    emit pageShown();
}

void PageStack::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void PageStack::retranslate() {
    for (int tab = 0; tab < tabs_->count(); ++tab) {
        tabs_->setTabText(tab, QCoreApplication::translate("Pages", titles_[tab]));
        tabs_->setTabToolTip(tab, QKeySequence(QKeyCombination(Qt::CTRL, Qt::Key(Qt::Key_1 + tab)))
                                      .toString(QKeySequence::NativeText));
    }
    tabs_->setAccessibleName(tr("Pages"));
}

}  // namespace vybeg::ui
