#include "ui/window/help_view.h"

#include "ui/widgets/page_parts.h"

#include <QAction>
#include <QFile>
#include <QToolBar>
#include <QVBoxLayout>

namespace vybeg::ui {

namespace {

QUrl pageUrl(const QString& language, const QString& page) {
    return QUrl(QStringLiteral("qrc:/help/%1/%2").arg(language, page));
}

}  // namespace

HelpView::HelpView(const QString& language, QWidget* parent)
    : QWidget(parent, Qt::Window), browser_(new QTextBrowser(this)) {
    resize(820, 720);
    browser_->setOpenLinks(true);
    browser_->setOpenExternalLinks(true);
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->document()->setDocumentMargin(18);
    auto* bar = new QToolBar(this);
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    back_ = bar->addAction(QString());
    forward_ = bar->addAction(QString());
    home_ = bar->addAction(QString());
    back_->setShortcut(QKeySequence::Back);
    forward_->setShortcut(QKeySequence::Forward);
    home_->setShortcut(QKeyCombination(Qt::ALT, Qt::Key_Home));
    fill(new QVBoxLayout(this), {}, 0, {bar, {browser_, 1}});
    connect(back_, &QAction::triggered, browser_, &QTextBrowser::backward);
    connect(forward_, &QAction::triggered, browser_, &QTextBrowser::forward);
    connect(home_, &QAction::triggered, this,
            [this] { browser_->setSource(pageUrl(language_, QStringLiteral("index.html"))); });
    connect(browser_, &QTextBrowser::backwardAvailable, back_, &QAction::setEnabled);
    connect(browser_, &QTextBrowser::forwardAvailable, forward_, &QAction::setEnabled);
    back_->setEnabled(false);
    forward_->setEnabled(false);
    setLanguage(language);
    keepTranslated(*this, [this] { retranslate(); });
}

void HelpView::setLanguage(const QString& language) {
    if (language == language_) {
        return;
    }
    language_ = language;
    QString page = browser_->source().fileName();
    if (page.isEmpty() || !QFile::exists(QStringLiteral(":/help/%1/%2").arg(language, page))) {
        page = QStringLiteral("index.html");
    }
    browser_->setSource(pageUrl(language, page));
}

void HelpView::retranslate() {
    setWindowTitle(tr("Vybeg help"));
    browser_->setAccessibleName(tr("Help page"));
    back_->setText(tr("Back"));
    forward_->setText(tr("Forward"));
    home_->setText(tr("Contents"));
}

}  // namespace vybeg::ui
