#pragma once

#include "core/base/result.h"
#include "ui/document/background_jobs.h"

#include <QByteArray>
#include <QJsonObject>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <functional>
#include <memory>
#include <vector>

namespace vybeg::ui {

// Distinguishes contents of files.
QByteArray digest(const QByteArray& bytes);

// Writes states of sessions into their files in the background, one after the other: a slow disk
// keeps no window. Of the states that wait for one file the newest is written, and each file is
// whole at any moment.
class SessionWriter : public QObject {
    Q_OBJECT

public:
    // Gets the digest of the bytes written.
    using Done = std::function<void(const Result<QByteArray>&)>;
    // Puts bytes into a file.
    using Disk = std::function<Status(const QString& path, const QByteArray& bytes)>;

    // Waits for the states that are asked for; their `done` are not called.
    ~SessionWriter() override;

    void write(const QString& path, const QJsonObject& state, Done done);
    bool busy() const { return !waiting_.empty(); }
    // Returns when all states that are asked for are written.
    void finish() { job_.finish(); }
    // Of all writers; a test's own one may be slow or fail. Empty: the disk.
    static void setDisk(Disk disk);

private:
    struct Waiting {
        QString path;
        QJsonObject state;
        std::vector<Done> done;
    };

    void begin();

    BackgroundJobs job_;
    std::vector<Waiting> waiting_;  // the first one is being written
};

// Copies of a session in the user's folder for data, so that a crash loses ten seconds at most. A
// lock beside the copy distinguishes copies of running programs from abandoned ones.
class SessionBackup : public QObject {
    Q_OBJECT

public:
    // `content`: the state to be copied; empty where nothing is worth a copy.
    explicit SessionBackup(std::function<QJsonObject()> content);

    // A copy at the next turn of the event loop: something was computed.
    void soon();
    // An abandoned copy whose session this program has opened: it goes when there is another one on
    // the disk.
    void take(const QString& path);
    // Waits for the copy that is being written and removes it; there are no more.
    void end();
    // Copies of programs that are not running any more, oldest first.
    static QStringList abandoned();
    static void discard(const QString& path);
    // Renames a declined copy, so that it stays and is not offered again; returns its new path.
    static QString setAside(const QString& path);

private:
    void write();

    std::function<QJsonObject()> content_;
    QString path_;
    std::unique_ptr<QLockFile> lock_;
    QJsonObject written_;
    QTimer timer_;
    QTimer soon_;
    SessionWriter writer_;
    QStringList taken_;
};

}  // namespace vybeg::ui
