#include "tests/layering/source_tree.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

namespace vybeg::test {
namespace {

QStringList linesOf(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
    if (lines.last().isEmpty()) {
        lines.removeLast();
    }
    return lines;
}

QStringList sourcePaths(const QDir& root, const QString& top) {
    QStringList paths;
    QDirIterator walk(root.filePath(top), {"*.h", "*.cpp"}, QDir::Files,
                      QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        paths += root.relativeFilePath(walk.next());
    }
    paths.sort();
    return paths;
}

QList<Include> includesOf(const QStringList& lines) {
    static const QRegularExpression directive("^\\s*#\\s*include\\s*([<\"])([^>\"]+)");
    QList<Include> includes;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        if (const auto match = directive.match(lines[i]); match.hasMatch()) {
            includes += {match.captured(2), match.captured(1) == "\"", static_cast<int>(i + 1)};
        }
    }
    return includes;
}

}  // namespace

QList<SourceFile> readSources(const QDir& root) {
    QList<SourceFile> files;
    for (const char* top : {"core", "ui", "app", "tests"}) {
        for (const QString& path : sourcePaths(root, top)) {
            const QStringList lines = linesOf(root.filePath(path));
            files += {path, lines, includesOf(lines)};
        }
    }
    return files;
}

QStringList foldersInOrder(const QDir& root, const QString& top) {
    static const QRegularExpression added("^\\s*add_subdirectory\\((\\w+)\\)");
    QStringList folders;
    for (const QString& line : linesOf(root.filePath(top + "/CMakeLists.txt"))) {
        if (const auto match = added.match(line); match.hasMatch()) {
            const QString folder = top + '/' + match.captured(1);
            const QStringList below = foldersInOrder(root, folder);
            folders += below.isEmpty() ? QStringList{folder} : below;
        }
    }
    return folders;
}

}  // namespace vybeg::test
