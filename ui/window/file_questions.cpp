#include "ui/window/file_questions.h"

#include "core/recording/open/open_recording.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QSettings>

namespace vybeg::ui {

namespace {

const QString folder_key = QStringLiteral("folder");

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

void FileQuestions::keepFolder(const QString& answer, Folder folder) {
    if (folder == Folder::follows) {
        QSettings().setValue(folder_key, QFileInfo(answer).absolutePath());
    }
}

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

void FileQuestions::recordings(const Files& open) {
    const QString audio = endingsOf(FileFormat::Group::audio);
    const QString tables = endingsOf(FileFormat::Group::tables);
    const QString arrays = endingsOf(FileFormat::Group::arrays);
    files(tr("Open recordings"),
          {tr("Recordings and sessions (%1)")
               .arg(QStringLiteral("*.vybeg ") + audio + QLatin1Char(' ') + tables +
                    QLatin1Char(' ') + arrays),
           tr("Sessions (%1)").arg(QStringLiteral("*.vybeg")), tr("Audio (%1)").arg(audio),
           tr("Tables of numbers (%1)").arg(tables), tr("Arrays (%1)").arg(arrays)},
          open);
}

void FileQuestions::logs(const Files& open) {
    files(tr("Open logs"),
          {tr("Logs (%1)")
               .arg(endingsOf(FileFormat::Group::tables) + QLatin1Char(' ') +
                    endingsOf(FileFormat::Group::arrays) + QStringLiteral(" *.zip"))},
          open);
}

void FileQuestions::parts(const Files& take) {
    files(tr("Files of the recording"), {}, take, Folder::stays);
}

void FileQuestions::wholeAngleLogs(const Files& open) {
    files(tr("Open whole-angle logs"),
          {tr("Tables of numbers (%1)").arg(endingsOf(FileFormat::Group::tables)),
           tr("Arrays (%1)").arg(endingsOf(FileFormat::Group::arrays))},
          open);
}

void FileQuestions::file(const QString& title, const QStringList& filters, const File& open,
                         Folder folder, const QString& now) {
    QFileDialog& asked = dialog(title);
    asked.setFileMode(QFileDialog::ExistingFile);
    asked.setNameFilters(filters + QStringList{tr("All files (*)")});
    if (!now.isEmpty()) {
        asked.selectFile(now);
    }
    connect(&asked, &QFileDialog::fileSelected, this, [open, folder](const QString& answer) {
        keepFolder(answer, folder);
        open(answer);
    });
    asked.open();
}

void FileQuestions::files(const QString& title, const QStringList& filters, const Files& open,
                          Folder folder) {
    QFileDialog& asked = dialog(title);
    asked.setFileMode(QFileDialog::ExistingFiles);
    asked.setNameFilters(filters + QStringList{tr("All files (*)")});
    connect(&asked, &QFileDialog::filesSelected, this, [open, folder](const QStringList& answer) {
        keepFolder(answer.first(), folder);
        open(answer);
    });
    asked.open();
}

void FileQuestions::folder(const QString& title, const File& open) {
    QFileDialog& asked = dialog(title);
    asked.setFileMode(QFileDialog::Directory);
    asked.setNameFilter(tr("All files (*)"));
    asked.setOption(QFileDialog::ShowDirsOnly);
    connect(&asked, &QFileDialog::fileSelected, this, open);
    asked.open();
}

void FileQuestions::target(const QString& title, const QString& name, const QStringList& filters,
                           const File& save, Existing existing) {
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

}  // namespace vybeg::ui

#include "moc_file_questions.cpp"
