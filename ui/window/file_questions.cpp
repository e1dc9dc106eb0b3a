#include "ui/window/file_questions.h"

#include "core/recording/open/file_format.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QSettings>

#include <algorithm>

namespace vybeg::ui {

namespace {

const QString folder_key = QStringLiteral("folder");

void keepFolder(const QString& file) {
    QSettings().setValue(folder_key, QFileInfo(file).absolutePath());
}

// The patterns of the names of a group's files.
QString endingsOf(FileFormat::Group group) {
    QStringList patterns;
    for (const FileFormat& format : file_formats()) {
        const auto endings =
            QString::fromUtf8(format.endings.data(), qsizetype(format.endings.size()));
        for (const QString& ending : endings.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            if (format.group == group) {
                patterns.append(QStringLiteral("*.") + ending);
            }
        }
    }
    return patterns.join(QLatin1Char(' '));
}

}  // namespace

FileQuestions::FileQuestions(QWidget* window) : QObject(window), window_(window) {}

// Empty and as `title` asks for it, with no answer connected.
QFileDialog& FileQuestions::dialog(const QString& title) {
    const QString name = QStringLiteral("files");
    auto* dialog = window_->findChild<QFileDialog*>(name, Qt::FindDirectChildrenOnly);
    if (!dialog) {
        dialog = new QFileDialog(window_);
        dialog->setObjectName(name);
    }
    disconnect(dialog, nullptr, this, nullptr);
    dialog->setWindowTitle(title);
    dialog->setAcceptMode(QFileDialog::AcceptOpen);
    dialog->setDefaultSuffix(QString());
    dialog->setOption(QFileDialog::ShowDirsOnly, false);
    dialog->setOption(QFileDialog::DontConfirmOverwrite, false);
    const QString folder = QSettings().value(folder_key).toString();
    dialog->setDirectory(folder.isEmpty() ? QDir::currentPath() : folder);
    if (auto* edit = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))) {
        edit->clear();  // the answer to an earlier question
    }
    return *dialog;
}

void FileQuestions::recordings(const std::function<void(const QStringList&)>& open) {
    QFileDialog& asked = dialog(tr("Open recordings"));
    asked.setFileMode(QFileDialog::ExistingFiles);
    const QString audio = endingsOf(FileFormat::Group::audio);
    const QString tables = endingsOf(FileFormat::Group::tables);
    const QString arrays = endingsOf(FileFormat::Group::arrays);
    asked.setNameFilters({tr("Recordings and sessions (%1)")
                              .arg(QStringLiteral("*.vybeg ") + audio + QLatin1Char(' ') + tables +
                                   QLatin1Char(' ') + arrays),
                          tr("Sessions (%1)").arg(QStringLiteral("*.vybeg")),
                          tr("Audio (%1)").arg(audio), tr("Tables of numbers (%1)").arg(tables),
                          tr("Arrays (%1)").arg(arrays), tr("All files (*)")});
    connect(&asked, &QFileDialog::filesSelected, this, [open](const QStringList& files) {
        keepFolder(files.first());
        open(files);
    });
    asked.open();
}

void FileQuestions::logs(const std::function<void(const QStringList&)>& open) {
    QFileDialog& asked = dialog(tr("Open logs"));
    asked.setFileMode(QFileDialog::ExistingFiles);
    asked.setNameFilters({tr("Logs (%1)")
                              .arg(endingsOf(FileFormat::Group::tables) + QLatin1Char(' ') +
                                   endingsOf(FileFormat::Group::arrays) + QStringLiteral(" *.zip")),
                          tr("All files (*)")});
    connect(&asked, &QFileDialog::filesSelected, this, [open](const QStringList& files) {
        keepFolder(files.first());
        open(files);
    });
    asked.open();
}

void FileQuestions::parts(const std::function<void(const QStringList&)>& take) {
    QFileDialog& asked = dialog(tr("Files of the recording"));
    asked.setFileMode(QFileDialog::ExistingFiles);
    asked.setNameFilter(tr("All files (*)"));
    connect(&asked, &QFileDialog::filesSelected, this, take);
    asked.open();
}

void FileQuestions::import(const QString& now, const std::function<void(const QString&)>& open) {
    QFileDialog& asked = dialog(tr("Import a recording"));
    asked.setFileMode(QFileDialog::ExistingFile);
    asked.setNameFilter(tr("All files (*)"));
    if (!now.isEmpty()) {
        asked.selectFile(now);
    }
    connect(&asked, &QFileDialog::fileSelected, this, [open](const QString& file) {
        keepFolder(file);
        open(file);
    });
    asked.open();
}

void FileQuestions::missingRecording(const QString& name,
                                     const std::function<void(const QString&)>& open) {
    QFileDialog& asked = dialog(tr("Where is %1?").arg(name));
    asked.setFileMode(QFileDialog::ExistingFile);
    asked.setNameFilter(tr("All files (*)"));
    connect(&asked, &QFileDialog::fileSelected, this, open);
    asked.open();
}

void FileQuestions::passport(const std::function<void(const QString&)>& open) {
    QFileDialog& asked = dialog(tr("Compare with passport"));
    asked.setFileMode(QFileDialog::ExistingFile);
    asked.setNameFilters({tr("Passport (*.json)"), tr("All files (*)")});
    connect(&asked, &QFileDialog::fileSelected, this, open);
    asked.open();
}

void FileQuestions::database(const std::function<void(const QString&)>& open) {
    QFileDialog& asked = dialog(tr("Open database"));
    asked.setFileMode(QFileDialog::ExistingFile);
    asked.setNameFilters({tr("Database of results (*.db *.sqlite)"), tr("All files (*)")});
    connect(&asked, &QFileDialog::fileSelected, this, open);
    asked.open();
}

void FileQuestions::wholeAngleLogs(const std::function<void(const QStringList&)>& open) {
    QFileDialog& asked = dialog(tr("Open whole-angle logs"));
    asked.setFileMode(QFileDialog::ExistingFiles);
    asked.setNameFilters({tr("Tables of numbers (%1)").arg(endingsOf(FileFormat::Group::tables)),
                          tr("Arrays (%1)").arg(endingsOf(FileFormat::Group::arrays)),
                          tr("All files (*)")});
    connect(&asked, &QFileDialog::filesSelected, this, [open](const QStringList& files) {
        keepFolder(files.first());
        open(files);
    });
    asked.open();
}

void FileQuestions::list(const std::function<void(const QString&)>& open) {
    QFileDialog& asked = dialog(tr("Measurement list"));
    asked.setFileMode(QFileDialog::ExistingFile);
    asked.setNameFilters({tr("Measurement list (*.csv *.txt)"), tr("All files (*)")});
    connect(&asked, &QFileDialog::fileSelected, this, [open](const QString& file) {
        keepFolder(file);
        open(file);
    });
    asked.open();
}

void FileQuestions::folder(const QString& title, const std::function<void(const QString&)>& open) {
    QFileDialog& asked = dialog(title);
    asked.setFileMode(QFileDialog::Directory);
    asked.setNameFilter(tr("All files (*)"));
    asked.setOption(QFileDialog::ShowDirsOnly);
    connect(&asked, &QFileDialog::fileSelected, this, open);
    asked.open();
}

void FileQuestions::sessionTarget(const QString& name, const Save& save) {
    target(tr("Save session"), name + QStringLiteral(".vybeg"), {tr("Session (*.vybeg)")}, save);
}

void FileQuestions::trackTarget(const QString& name, const Save& save) {
    target(tr("Export track"), name + QStringLiteral(".csv"),
           {tr("Track (*.csv)"), tr("Track for MATLAB (*.mat)"), tr("Track, HDF5 (*.h5)"),
            tr("Track for NumPy (*.npz)")},
           save);
}

void FileQuestions::passportTarget(const Save& save) {
    target(tr("Save passport"), QStringLiteral("passport.json"), {tr("Passport (*.json)")}, save);
}

void FileQuestions::databaseTarget(const Save& save) {
    target(tr("New database"), QStringLiteral("results.db"), {tr("Database of results (*.db)")},
           save);
}

void FileQuestions::databaseToFill(const Save& save) {
    target(tr("Database of results"), QStringLiteral("results.db"),
           {tr("Database of results (*.db *.sqlite)")}, save, Existing::stays);
}

void FileQuestions::tableTarget(const QString& name, const Save& save) {
    target(tr("Results"), name, {tr("Table (*.csv)")}, save, Existing::stays);
}

void FileQuestions::picture(const QString& name, const Save& save) {
    pictureTarget(tr("Export plots"), name + QStringLiteral(".png"), save);
}

void FileQuestions::historyTarget(const QString& name, const Save& save) {
    target(tr("Export history"), name + QStringLiteral(".csv"),
           {tr("Table (*.csv)"), tr("PDF document (*.pdf)")}, save);
}

void FileQuestions::driftTarget(const Save& save) {
    target(tr("Export drift"), QStringLiteral("drift.csv"),
           {tr("Table (*.csv)"), tr("Result (*.json)")}, save);
}

void FileQuestions::reportTarget(const QString& name, const Save& save) {
    target(tr("Save report"), name + QStringLiteral(".pdf"), {tr("PDF document (*.pdf)")}, save);
}

void FileQuestions::target(const QString& title, const QString& name, const QStringList& filters,
                           const Save& save, Existing existing) {
    QFileDialog& asked = dialog(title);
    asked.setAcceptMode(QFileDialog::AcceptSave);
    asked.setOption(QFileDialog::DontConfirmOverwrite, existing == Existing::stays);
    asked.setFileMode(QFileDialog::AnyFile);
    asked.setNameFilters(filters);
    asked.selectFile(name);
    asked.setDefaultSuffix(QFileInfo(name).suffix());
    connect(&asked, &QFileDialog::filterSelected, this, [&asked](const QString& filter) {
        asked.setDefaultSuffix(filter.section(QStringLiteral("*."), 1).chopped(1));
    });
    connect(&asked, &QFileDialog::fileSelected, this, save);
    asked.open();
}

void FileQuestions::pictureTarget(const QString& title, const QString& name, const Save& save) {
    QStringList filters{tr("PNG image (*.png)"), tr("SVG drawing (*.svg)"),
                        tr("PDF document (*.pdf)")};
    const QString ending = QFileInfo(name).suffix();
    std::stable_partition(filters.begin(), filters.end(), [&](const QString& filter) {
        return filter.endsWith(QStringLiteral("*.%1)").arg(ending));
    });
    target(title, name, filters, save);
}

}  // namespace vybeg::ui
