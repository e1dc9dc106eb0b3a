#include "tests/layering/layering.h"

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

QStringList sourceFiles(const QDir& root, const QString& top) {
    QStringList files;
    QDirIterator walk(root.filePath(top), {"*.h", "*.cpp"}, QDir::Files,
                      QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        files += root.relativeFilePath(walk.next());
    }
    files.sort();
    return files;
}

bool isQt(const QString& header) {
    static const QRegularExpression qt(
        "^(Q[A-Za-z0-9]+(/.*)?|q[a-z0-9_]+\\.h|ui_.*\\.h|.*\\.moc)$");
    return qt.match(header).hasMatch();
}

// One file on its way through the rules: where it stands, and what it includes.
struct Include {
    QString file;    // from the root, e.g. "core/windows/carrier.cpp"
    QString header;  // as written, e.g. "core/base/result.h"
    bool quoted = false;

    QString top() const { return file.section('/', 0, 0); }
    bool of(const QString& folder) const { return header.startsWith(folder + '/'); }
    bool commandLine() const { return top() == "app" && !file.section('/', -1).startsWith("gui"); }
};

QString coreViolation(const Include& include, const QStringList& folders) {
    const auto own = folders.indexOf(include.file.section('/', 1, 1));
    if (own < 0) {
        return "its folder is not in core/CMakeLists.txt";
    }
    if (include.of("ui") || include.of("app") || include.of("tests")) {
        return "core/ includes " + include.header;
    }
    if (include.of("core")) {
        const auto other = folders.indexOf(include.header.section('/', 1, 1));
        if (other < 0 || other > own) {
            return "a later folder of core/: " + include.header;
        }
    }
    return {};
}

QString violation(const Include& include, const QStringList& folders) {
    const QString top = include.top();
    if (top == "tests") {
        return {};
    }
    if ((top == "core" || include.commandLine()) && isQt(include.header)) {
        return "Qt: " + include.header;
    }
    const bool fromRoot = include.of("core") || include.of("ui") || include.of("app");
    if (include.quoted && !fromRoot && !include.of("tests") && !isQt(include.header)) {
        return "not included from the root: " + include.header;
    }
    if (top == "core") {
        return coreViolation(include, folders);
    }
    if (include.of("tests") || (top == "ui" && include.of("app"))) {
        return top + "/ includes " + include.header;
    }
    if (include.commandLine() && (include.of("ui") || include.header.startsWith("app/gui"))) {
        return "the command line includes " + include.header;
    }
    return {};
}

}  // namespace

QStringList coreFolders(const QDir& root) {
    static const QRegularExpression added("^\\s*add_subdirectory\\((\\w+)\\)");
    QStringList folders;
    for (const QString& line : linesOf(root.filePath("core/CMakeLists.txt"))) {
        if (const auto match = added.match(line); match.hasMatch()) {
            folders += match.captured(1);
        }
    }
    return folders;
}

QStringList layeringViolations(const QDir& root) {
    static const QRegularExpression directive("^\\s*#\\s*include\\s*([<\"])([^>\"]+)");
    const QStringList folders = coreFolders(root);
    QStringList found;
    for (const char* top : {"core", "ui", "app", "tests"}) {
        for (const QString& file : sourceFiles(root, top)) {
            const QStringList lines = linesOf(root.filePath(file));
            for (qsizetype i = 0; i < lines.size(); ++i) {
                const auto match = directive.match(lines[i]);
                if (!match.hasMatch()) {
                    continue;
                }
                const QString what =
                    violation({file, match.captured(2), match.captured(1) == "\""}, folders);
                if (!what.isEmpty()) {
                    found += QString("%1:%2: %3").arg(file).arg(i + 1).arg(what);
                }
            }
            if (lines.size() > longest_file) {
                found += QString("%1:%2: longer than %3 lines")
                             .arg(file)
                             .arg(lines.size())
                             .arg(longest_file);
            }
        }
    }
    return found;
}

}  // namespace vybeg::test
