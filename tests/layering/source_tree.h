#pragma once

#include <QDir>
#include <QList>
#include <QString>
#include <QStringList>

namespace vybeg::test {

struct Include {
    QString header;  // as written, e.g. "core/base/result.h"
    bool quoted = false;
    int line = 0;  // from 1
};

struct SourceFile {
    QString path;  // from the root, e.g. "core/windows/carrier.cpp"
    QStringList lines;
    QList<Include> includes;

    QString top() const { return path.section('/', 0, 0); }
    QString folder() const { return path.section('/', 0, -2); }
    // A header with its source is one unit: the path without its ending.
    QString unit() const { return path.section('.', 0, -2); }
};

// The headers and sources of core/, ui/, app/ and tests/, by path.
QList<SourceFile> readSources(const QDir& root);

// Folders that hold sources, in the order of the way of the data, as the CMakeLists.txt of `top`
// and of its folders add them: "core/base", "core/recording/bytes", ...
QStringList foldersInOrder(const QDir& root, const QString& top);

}  // namespace vybeg::test
