#pragma once

#include "core/base/result.h"
#include "ui/document/background_jobs.h"

#include <QByteArray>
#include <QJsonObject>
#include <QObject>
#include <QString>

#include <functional>
#include <vector>

namespace vybeg::ui {

// Tells contents of files apart.
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
    void finish();
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

}  // namespace vybeg::ui
