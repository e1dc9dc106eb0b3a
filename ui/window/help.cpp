#include "ui/window/help.h"

#include "ui/document/document.h"
#include "ui/widgets/page_parts.h"

#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QShortcut>
#include <QSysInfo>
#include <QTextDocument>
#include <QThread>
#include <QToolBar>
#include <QToolTip>
#include <QVBoxLayout>
#include <qcustomplot.h>

namespace vybeg::ui {

namespace {

QUrl pageUrl(const QString& language, const QString& page) {
    return QUrl(QStringLiteral("qrc:/help/%1/%2").arg(language, page));
}

bool holds(const QString& page, const QString& text) {
    QFile file(page);
    QTextDocument document;
    if (file.open(QIODevice::ReadOnly)) {
        document.setHtml(QString::fromUtf8(file.readAll()));
    }
    return !document.find(text).isNull();
}

}  // namespace

HelpView::HelpView(const QString& language, QWidget* parent)
    : QWidget(parent, Qt::Window), browser_(new QTextBrowser(this)), wanted_(new QLineEdit(this)) {
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
    auto* between = new QWidget(bar);
    between->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(between);
    wanted_->setClearButtonEnabled(true);
    wanted_->setMaximumWidth(240);
    bar->addWidget(wanted_);
    fill(new QVBoxLayout(this), {}, 0, {bar, {browser_, 1}});
    connect(wanted_, &QLineEdit::returnPressed, this, &HelpView::findNext);
    connect(new QShortcut(QKeySequence::FindNext, this), &QShortcut::activated, this,
            &HelpView::findNext);
    connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, wanted_, [this] {
        wanted_->setFocus();
        wanted_->selectAll();
    });
    connect(back_, &QAction::triggered, browser_, &QTextBrowser::backward);
    connect(forward_, &QAction::triggered, browser_, &QTextBrowser::forward);
    connect(home_, &QAction::triggered, this,
            [this] { browser_->setSource(pageUrl(language_, QStringLiteral("index.html"))); });
    connect(browser_, &QTextBrowser::backwardAvailable, back_, &QAction::setEnabled);
    connect(browser_, &QTextBrowser::forwardAvailable, forward_, &QAction::setEnabled);
    back_->setEnabled(false);
    forward_->setEnabled(false);
    setLanguage(language);
    // The page keeps the colour that links had.
    whenChanged(*browser_, {QEvent::PaletteChange}, [this] {
        const int place = browser_->verticalScrollBar()->value();
        browser_->reload();
        browser_->verticalScrollBar()->setValue(place);
    });
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

void HelpView::findNext() {
    const QString text = wanted_->text();
    if (text.isEmpty() || browser_->find(text)) {
        return;
    }
    const QDir folder(QStringLiteral(":/help/") + language_);
    const QStringList pages = folder.entryList({QStringLiteral("*.html")});
    const qsizetype here = pages.indexOf(browser_->source().fileName());
    // The last one is this page again, from its beginning.
    for (qsizetype k = 1; k <= pages.size(); ++k) {
        const QString& page = pages[(here + k) % pages.size()];
        if (holds(folder.filePath(page), text)) {
            browser_->setSource(pageUrl(language_, page));
            browser_->moveCursor(QTextCursor::Start);
            browser_->find(text);
            return;
        }
    }
    QToolTip::showText(
        wanted_->mapToGlobal(wanted_->rect().bottomLeft()),
        QStringLiteral("<qt>%1</qt>").arg(tr("No page has “%1”.").arg(text.toHtmlEscaped())),
        wanted_);
}

void HelpView::retranslate() {
    setWindowTitle(tr("Vybeg help"));
    wanted_->setPlaceholderText(tr("Find"));
    wanted_->setAccessibleName(tr("Text to find in the help"));
    browser_->setAccessibleName(tr("Help page"));
    back_->setText(tr("Back"));
    forward_->setText(tr("Forward"));
    home_->setText(tr("Contents"));
}

namespace {

struct AboutWords {
    Q_DECLARE_TR_FUNCTIONS(About)
};

}  // namespace

QString diagnosticsOf(const Document& document, const QString& language, bool dark, double scale) {
    QStringList lines;
    lines << QStringLiteral("Vybeg %1").arg(QCoreApplication::applicationVersion())
          << QStringLiteral("Qt %1 (built with %2), platform %3")
                 .arg(QLatin1String(qVersion()), QLatin1String(QT_VERSION_STR),
                      QGuiApplication::platformName())
          << QStringLiteral("QCustomPlot %1").arg(QLatin1String(QCUSTOMPLOT_VERSION_STR))
          << QStringLiteral("%1, %2, %3 processors")
                 .arg(QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture())
                 .arg(QThread::idealThreadCount())
          << QStringLiteral("Language %1, theme %2, scale %3")
                 .arg(language, dark ? QStringLiteral("dark") : QStringLiteral("light"))
                 .arg(scale)
          << QStringLiteral("Recordings: %1, analyses: %2")
                 .arg(document.recordings().size())
                 .arg(document.analyses().size());
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void showAbout(QWidget* window, QAction* copy_diagnostics) {
    auto* dialog = new QDialog(window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(AboutWords::tr("About Vybeg"));
    auto* text = new QLabel(
        AboutWords::tr("<h3>Vybeg %1</h3><p>Standing waves in the free decay of hemispherical "
                       "resonator gyros.</p><p>Qt %2, QCustomPlot %3</p><p>Free software: GNU "
                       "General Public License, version 3 or later.</p>")
            .arg(QCoreApplication::applicationVersion(), QLatin1String(qVersion()),
                 QLatin1String(QCUSTOMPLOT_VERSION_STR)),
        dialog);
    text->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    QPushButton* copy =
        buttons->addButton(AboutWords::tr("Copy diagnostics"), QDialogButtonBox::ActionRole);
    QObject::connect(copy, &QPushButton::clicked, copy_diagnostics, &QAction::trigger);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    fill(new QVBoxLayout(dialog), {text, buttons});
    dialog->open();
}

}  // namespace vybeg::ui

#include "moc_help.cpp"
