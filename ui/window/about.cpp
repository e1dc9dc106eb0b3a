#include "ui/window/about.h"

#include "ui/document/document.h"
#include "ui/widgets/page_parts.h"

#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSysInfo>
#include <QThread>
#include <QVBoxLayout>
#include <qcustomplot.h>

namespace vybeg::ui {

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
