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
    using Save = std::function<void(const QString&)>;

    explicit FileQuestions(QWidget* window);

    // Recordings and sessions to open.
    void recordings(const std::function<void(const QStringList&)>& open);
    // One file to open in a way of its own; `now` is chosen already where there is one.
    void import(const QString& now, const std::function<void(const QString&)>& open);
    // Logs in place of recordings.
    void logs(const std::function<void(const QStringList&)>& open);
    // The other files of one recording.
    void parts(const std::function<void(const QStringList&)>& take);
    // In the place of one that is not where it was.
    void missingRecording(const QString& name, const std::function<void(const QString&)>& open);
    void passport(const std::function<void(const QString&)>& open);
    void database(const std::function<void(const QString&)>& open);
    void wholeAngleLogs(const std::function<void(const QStringList&)>& open);
    void list(const std::function<void(const QString&)>& open);
    void folder(const QString& title, const std::function<void(const QString&)>& open);
    // Where to write what.
    // `name` without its ending.
    void sessionTarget(const QString& name, const Save& save);
    // CSV, HDF5, NPZ or MAT. `name` without its ending.
    void trackTarget(const QString& name, const Save& save);
    void passportTarget(const Save& save);
    void databaseTarget(const Save& save);
    // A database that results are added to: a new one or one that is there.
    void databaseToFill(const Save& save);
    // A table of results, whose writer asks before it replaces one. A path with its folder.
    void tableTarget(const QString& name, const Save& save);
    // A PNG, SVG or PDF; `name` without its ending.
    void picture(const QString& name, const Save& save);
    // A table (CSV) or a report (PDF); `name` without its ending.
    void historyTarget(const QString& name, const Save& save);
    // A table (CSV) or the result (JSON).
    void driftTarget(const Save& save);
    // A PDF; `name` without its ending.
    void reportTarget(const QString& name, const Save& save);

private:
    QFileDialog& dialog(const QString& title);
    // Whether the answer may be a file that is there without a further question.
    enum class Existing : bool { replaced, stays };
    // `name` with its ending is proposed.
    void target(const QString& title, const QString& name, const QStringList& filters,
                const Save& save, Existing existing = Existing::replaced);
    // The ending of `name` first.
    void pictureTarget(const QString& title, const QString& name, const Save& save);

    QWidget* window_;
};

}  // namespace vybeg::ui
