#pragma once

#include <QByteArray>
#include <QDir>
#include <QJsonObject>
#include <QString>

namespace vybeg::ui {

// Bytes of a session's file.
QByteArray bytesOf(const QJsonObject& json);

// Tells contents of files apart.
QByteArray digest(const QByteArray& bytes);

// A file in the session's folder or a folder in it for a recording that is not at its path: one of
// its name, otherwise one of its ending and content, as far as 256 MB tell. Empty: none.
QString foundNear(const QDir& folder, const QString& path, const QString& sha256);

}  // namespace vybeg::ui
