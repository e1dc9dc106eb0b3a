#pragma once

#include <QObject>
#include <QStringList>

#include <functional>

class QFileDialog;
class QWidget;

namespace vybeg::ui {

// Asks for files, with one dialog for all questions: Qt keeps a third of a megabyte of every one
// that was opened. The folder of the last recording is kept between sessions.
class FileQuestions : public QObject {
    Q_OBJECT

public:
    using File = std::function<void(const QString&)>;
    using Files = std::function<void(const QStringList&)>;

    explicit FileQuestions(QWidget* window);

    // Recordings and sessions to open.
    void recordings(const Files& open);
    // One file to open in a way of its own; `now` is chosen already where there is one.
    void import(const QString& now, const File& open);
    // Logs in place of recordings.
    void logs(const Files& open);
    // The other files of one recording.
    void parts(const Files& take);
    // In the place of one that is not where it was.
    void missingRecording(const QString& name, const File& open);
    void passport(const File& open);
    void database(const File& open);
    void wholeAngleLogs(const Files& open);
    void list(const File& open);
    void folder(const QString& title, const File& open);
    // Where to write what.
    // `name` without its ending.
    void sessionTarget(const QString& name, const File& save);
    // CSV, HDF5, NPZ or MAT. `name` without its ending.
    void trackTarget(const QString& name, const File& save);
    void passportTarget(const File& save);
    void databaseTarget(const File& save);
    // A database that results are added to: a new one or one that is there.
    void databaseToFill(const File& save);
    // A table of results, whose writer asks before it replaces one. A path with its folder.
    void tableTarget(const QString& name, const File& save);
    // A PNG, SVG or PDF; `name` without its ending.
    void picture(const QString& name, const File& save);
    // A table (CSV) or a report (PDF); `name` without its ending.
    void historyTarget(const QString& name, const File& save);
    // A table (CSV) or the result (JSON).
    void driftTarget(const File& save);
    // A PDF; `name` without its ending.
    void reportTarget(const QString& name, const File& save);

private:
    // Whether later questions begin in the folder of the answer.
    enum class Folder : bool { stays, follows };
    static void keepFolder(const QString& answer, Folder folder);

    QFileDialog& dialog(const QString& title);
    // Files that are there, with the filters of their names; `now` is chosen already.
    void file(const QString& title, const QStringList& filters, const File& open,
              Folder folder = Folder::stays, const QString& now = {});
    void files(const QString& title, const QStringList& filters, const Files& open,
               Folder folder = Folder::follows);
    // Whether the answer may be a file that is there without a further question.
    enum class Existing : bool { replaced, stays };
    // `name` with its ending is proposed.
    void target(const QString& title, const QString& name, const QStringList& filters,
                const File& save, Existing existing = Existing::replaced);

    QWidget* window_;
};

}  // namespace vybeg::ui
