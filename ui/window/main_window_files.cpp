// Everything that goes in or out: opening, dropping, exporting, and the windows beside the main
// one.
#include "core/output/same_file.h"
#include "ui/import/import_dialog.h"
#include "ui/panels/recording_drag.h"
#include "ui/panels/run_list.h"
#include "ui/plots/plot_export.h"
#include "ui/plots/track_view.h"
#include "ui/window/compare_dialog.h"
#include "ui/window/help_view.h"
#include "ui/window/main_window.h"
#include "ui/words/error_text.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSysInfo>
#include <QThread>
#include <QVBoxLayout>
#include <qcustomplot.h>

namespace vybeg::ui {

namespace {

const QString folder_key = QStringLiteral("folder");

// The window's dialog for files, empty and as `title` asks for it, with no connection to the
// window. There is one for all questions: Qt keeps a third of a megabyte of every one that was
// opened.
QFileDialog& fileDialog(QWidget& window, const QString& title) {
    const QString name = QStringLiteral("files");
    auto* dialog = window.findChild<QFileDialog*>(name, Qt::FindDirectChildrenOnly);
    if (!dialog) {
        dialog = new QFileDialog(&window);
        dialog->setObjectName(name);
    }
    QObject::disconnect(dialog, nullptr, &window, nullptr);
    dialog->setWindowTitle(title);
    dialog->setAcceptMode(QFileDialog::AcceptOpen);
    dialog->setDefaultSuffix(QString());
    const QString folder = QSettings().value(folder_key).toString();
    dialog->setDirectory(folder.isEmpty() ? QDir::currentPath() : folder);
    if (auto* edit = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))) {
        edit->clear();  // what an earlier question was answered with
    }
    return *dialog;
}

// Whether a file would take the place of an open recording.
Status stayAsTheyAre(const Document& document, const QString& path) {
    for (const RecordingEntry& entry : document.recordings()) {
        if (same_file(entry.path.toStdU16String(), path.toStdU16String())) {
            return Error{ErrorCode::output_is_recording, path.toStdString(), {}};
        }
    }
    return {};
}

}  // namespace

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    document_.open(localFiles(*event->mimeData()));
    event->acceptProposedAction();
}

void MainWindow::askForFiles() {
    QFileDialog* const dialog = &fileDialog(*this, tr("Open recordings"));
    dialog->setFileMode(QFileDialog::ExistingFiles);
    const QString audio = QStringLiteral("*.wav *.w64 *.rf64 *.flac *.aif *.aiff *.caf");
    const QString tables = QStringLiteral("*.csv *.tsv *.txt *.dat");
    const QString arrays = QStringLiteral("*.npy *.npz *.mat *.h5 *.hdf5 *.tdms *.uff *.unv");
    dialog->setNameFilters(
        {tr("Recordings (%1)").arg(audio + QLatin1Char(' ') + tables + QLatin1Char(' ') + arrays),
         tr("Audio (%1)").arg(audio), tr("Tables of numbers (%1)").arg(tables),
         tr("Arrays (%1)").arg(arrays), tr("All files (*)")});
    connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
        QSettings().setValue(folder_key, QFileInfo(files.first()).absolutePath());
        document_.open(files);
    });
    dialog->open();
}

void MainWindow::askForImport() {
    const RecordingEntry* current = document_.currentRecording();
    QFileDialog* const dialog = &fileDialog(*this, tr("Import a recording"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(tr("All files (*)"));
    if (current) {
        dialog->selectFile(current->path);  // to read it in another way
    }
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
        QSettings().setValue(folder_key, QFileInfo(file).absolutePath());
        const RecordingEntry* entry = document_.currentRecording();
        openImport(file, entry && entry->path == file ? entry->options : OpenOptions{});
    });
    dialog->open();
}

void MainWindow::openImport(const QString& path, const OpenOptions& options) {
    delete import_;
    auto* dialog = new ImportDialog(imports_, path, options, this);
    import_ = dialog;
    connect(dialog, &ImportDialog::chosen, this,
            [this](const QString& file, const OpenOptions& chosen) {
                const RecordingEntry* entry = document_.currentRecording();
                if (entry && entry->path == file) {
                    document_.reopen(entry->id, chosen);
                } else {
                    document_.open({file}, chosen);
                }
            });
    dialog->open();
}

void MainWindow::askWhereTo(const QString& title, const QString& name, const QStringList& filters,
                            const std::function<void(const QString&)>& save) {
    QFileDialog* const dialog = &fileDialog(*this, title);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setFileMode(QFileDialog::AnyFile);
    dialog->setNameFilters(filters);
    dialog->selectFile(name);
    dialog->setDefaultSuffix(QFileInfo(name).suffix());
    connect(dialog, &QFileDialog::filterSelected, this, [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.section(QStringLiteral("*."), 1).chopped(1));
    });
    connect(dialog, &QFileDialog::fileSelected, this, save);
    dialog->open();
}

void MainWindow::told(const Status& status, const QString& path) {
    if (status) {
        document_.report({Severity::info, [path] { return tr("Written: %1").arg(path); }, {}, {}});
    } else {
        document_.reportError(status.error());
    }
}

void MainWindow::exportPlotsTo(const QString& path) {
    const Status possible = stayAsTheyAre(document_, path);
    const PlotContent content = tracks_->content();
    told(possible ? exportPlots(content, paperSize(content), path) : possible, path);
}

void MainWindow::exportTrackTo(const QString& path) {
    if (const Status possible = stayAsTheyAre(document_, path); !possible) {
        told(possible, path);
        return;
    }
    document_.exportTrack(runs_->currentRun(), path,
                          [this, path](const Status& status) { told(status, path); });
}

void MainWindow::exportFigureTo(const QString& path) {
    if (compare_) {
        FigureOptions options;
        options.units = tracks_->units();
        const Status possible = stayAsTheyAre(document_, path);
        told(possible ? renderFigure(compare_->columns(), path, options) : possible, path);
    }
}

void MainWindow::savePassportTo(const QString& path) {
    if (const Status possible = stayAsTheyAre(document_, path); !possible) {
        told(possible, path);
        return;
    }
    document_.savePassport(path, [this, path](const Status& status) { told(status, path); });
}

void MainWindow::comparePassport(const QString& path) {
    document_.openPassport(path);
}

void MainWindow::askForPassport() {
    QFileDialog* const dialog = &fileDialog(*this, tr("Compare with passport"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Passport (*.json)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::comparePassport);
    dialog->open();
}

void MainWindow::exportResonatorPlot(const XYPlot& plot) {
    askWhereTo(tr("Export plot"), QStringLiteral("resonator.png"),
               {tr("PNG image (*.png)"), tr("SVG drawing (*.svg)"), tr("PDF document (*.pdf)")},
               [this, plot](const QString& path) {
                   const Status possible = stayAsTheyAre(document_, path);
                   told(possible ? exportXYPlot(plot, xy_paper_size, path) : possible, path);
               });
}

void MainWindow::openCompare() {
    if (!compare_) {
        compare_ = new CompareDialog(this);
        connect(compare_, &CompareDialog::compareWanted, &document_, &Document::compareWindows);
        connect(compare_, &CompareDialog::exportWanted, this, [this] {
            askWhereTo(
                tr("Export figure"), QStringLiteral("figure.pdf"),
                {tr("PDF document (*.pdf)"), tr("SVG drawing (*.svg)"), tr("PNG image (*.png)")},
                [this](const QString& path) { exportFigureTo(path); });
        });
    }
    compare_->setBusy(document_.busy());
    compare_->show();
    compare_->raise();
    compare_->activateWindow();
}

void MainWindow::showComparison(const QList<int>& run_ids) {
    std::vector<FigureColumn> columns;
    for (const int id : run_ids) {
        if (const RunEntry* entry = document_.run(id)) {
            columns.push_back(
                {QStringLiteral("n = %1").arg(entry->run.analysis->plan.length), entry->run});
        }
    }
    openCompare();
    FigureOptions options;
    options.units = tracks_->units();
    compare_->showFigure(std::move(columns), options);
}

void MainWindow::showHelp() {
    if (!help_) {
        help_ = new HelpView(language_.code(), this);
    }
    help_->show();
    help_->raise();
    help_->activateWindow();
}

QString MainWindow::diagnosticsText() const {
    // English whatever the interface's language: it is read by those who mend the program.
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
                 .arg(language_.code(),
                      theme_.dark ? QStringLiteral("dark") : QStringLiteral("light"))
                 .arg(devicePixelRatioF())
          << QStringLiteral("Recordings: %1, runs: %2")
                 .arg(document_.recordings().size())
                 .arg(document_.runs().size());
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void MainWindow::showAbout() {
    auto* dialog = new QDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("About Vybeg"));
    auto* text = new QLabel(
        tr("<h3>Vybeg %1</h3><p>Standing waves in the free decay of hemispherical resonator "
           "gyros.</p><p>Qt %2, QCustomPlot %3</p><p>Free software: GNU General Public License, "
           "version 3 or later.</p>")
            .arg(QCoreApplication::applicationVersion(), QLatin1String(qVersion()),
                 QLatin1String(QCUSTOMPLOT_VERSION_STR)),
        dialog);
    text->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    QPushButton* copy = buttons->addButton(tr("Copy diagnostics"), QDialogButtonBox::ActionRole);
    connect(copy, &QPushButton::clicked, action(Command::copy_diagnostics), &QAction::trigger);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog->open();
}

}  // namespace vybeg::ui
