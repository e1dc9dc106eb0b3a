#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>

namespace vybeg::test {

// A whole file.
inline QByteArray content(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot be opened)");
}

// Writes a file anew; whether it went well.
[[nodiscard]] inline bool put(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

}  // namespace vybeg::test
