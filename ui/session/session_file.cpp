#include "ui/session/session_file.h"

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

QString foundNear(const QDir& folder, const QString& path) {
    const QString name = QFileInfo(path).fileName();
    QStringList folders = folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
    folders.prepend(QStringLiteral("."));
    for (const QString& each : folders) {
        const QString candidate = folder.absoluteFilePath(each + QLatin1Char('/') + name);
        if (QFileInfo(candidate).isFile()) {
            return QDir::cleanPath(candidate);
        }
    }
    return {};
}

}  // namespace vybeg::ui
