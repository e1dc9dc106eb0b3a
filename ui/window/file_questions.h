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
    // Whether later questions begin in the folder of the answer.
    enum class Folder : bool { stays, follows };
    // Whether the answer may be a file that is there without a further question.
    enum class Existing : bool { replaced, stays };

    explicit FileQuestions(QWidget* window);

    // Recordings and sessions to open.
    void recordings(const Files& open);
    // Logs in place of recordings.
    void logs(const Files& open);
    void wholeAngleLogs(const Files& open);
    // The other files of one recording.
    void parts(const Files& take);
    // A file that is there, one of `filters` or any other; `now` is chosen already where there is
    // one.
    void file(const QString& title, const QStringList& filters, const File& open,
              Folder folder = Folder::stays, const QString& now = {});
    void folder(const QString& title, const File& open);
    // Where to write; `name` with its ending is proposed.
    void target(const QString& title, const QString& name, const QStringList& filters,
                const File& save, Existing existing = Existing::replaced);

private:
    static void keepFolder(const QString& answer, Folder folder);

    QFileDialog& dialog(const QString& title);
    // Files that are there, as of file().
    void files(const QString& title, const QStringList& filters, const Files& open,
               Folder folder = Folder::follows);

    QWidget* window_;
};

}  // namespace vybeg::ui
