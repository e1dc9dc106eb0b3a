#include "ui/session/session_file.h"

#include "core/recording/bytes/sha256.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QJsonDocument>

namespace vybeg::ui {

QByteArray bytesOf(const QJsonObject& json) {
    return QJsonDocument(json).toJson(QJsonDocument::Indented);
}

QByteArray digest(const QByteArray& bytes) {
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
}

namespace {

// Of files under another name so much is read, which takes half a second.
constexpr qint64 most_bytes_read = 256'000'000;

// The session's folder and the folders in it.
QList<QDir> foldersOf(const QDir& folder) {
    QList<QDir> folders{folder};
    for (const QString& each : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        folders << QDir(folder.absoluteFilePath(each));
    }
    return folders;
}

}  // namespace

QString foundNear(const QDir& folder, const QString& path, const QString& sha256) {
    const QFileInfo missing(path);
    const QList<QDir> folders = foldersOf(folder);
    for (const QDir& each : folders) {
        const QString candidate = each.absoluteFilePath(missing.fileName());
        if (QFileInfo(candidate).isFile()) {
            return QDir::cleanPath(candidate);
        }
    }
    qint64 read = 0;
    for (const QDir& each : folders) {
        const QString ending = QStringLiteral("*.") + missing.suffix();
        for (const QFileInfo& file : each.entryInfoList({ending}, QDir::Files, QDir::Name)) {
            if (sha256.isEmpty() || (read += file.size()) > most_bytes_read) {
                return {};
            }
            const auto hash = file_sha256(file.absoluteFilePath().toStdU16String(), JobControl());
            if (hash && QString::fromStdString(*hash) == sha256) {
                return QDir::cleanPath(file.absoluteFilePath());
            }
        }
    }
    return {};
}

}  // namespace vybeg::ui
