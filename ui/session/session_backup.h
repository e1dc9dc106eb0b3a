#pragma once

#include "ui/session/session_writer.h"

#include <QJsonObject>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <functional>
#include <memory>

namespace vybeg::ui {

// Copies of a session in the user's folder for data, so that a crash loses ten seconds at most. A
// lock beside the copy tells the copies of running programs from abandoned ones.
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
    // Renames a declined copy, so that it stays and is not offered again.
    static void setAside(const QString& path);

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
