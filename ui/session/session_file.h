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

// A file of the same name in the session's folder or a folder in it, for a recording that is not at
// its path; empty: none.
QString foundNear(const QDir& folder, const QString& path);

}  // namespace vybeg::ui
