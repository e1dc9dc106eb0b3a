#include "tests/layering/class_sizes.h"

#include <QRegularExpression>

namespace vybeg::test {
namespace {

QString keyOf(const QString& path, const QString& name) {
    return path + ": " + name;
}

// Lines from `first` to the brace that closes a definition in the first column; 0 where a semicolon
// ends it before its body begins.
int definitionLines(const QStringList& lines, qsizetype first) {
    static const QRegularExpression comment("\\s*//.*$");
    bool body = false;
    for (qsizetype i = first; i < lines.size(); ++i) {
        const QString line = QString(lines[i]).remove(comment);
        const bool closed = line.endsWith('}') || line.endsWith("};");
        const bool empty_body = line.endsWith("{}") || line.endsWith("{};");
        if (line.startsWith('}') || (!body && (empty_body || (i == first && closed)))) {
            return static_cast<int>(i - first + 1);
        }
        if (!body && line.endsWith(';')) {
            return 0;
        }
        body = body || line.endsWith('{');
    }
    return 0;
}

void addDefinitions(const SourceFile& file, QMap<QString, int>& sizes) {
    static const QRegularExpression definition("^(?:class|struct) (?:alignas\\(\\w+\\) )?(\\w+)");
    for (qsizetype i = 0; i < file.lines.size(); ++i) {
        if (const auto match = definition.match(file.lines[i]); match.hasMatch()) {
            if (const int lines = definitionLines(file.lines, i); lines > 0) {
                sizes[keyOf(file.path, match.captured(1))] += lines;
            }
        }
    }
}

// The file that defines the class of a member: this one or a header that it includes.
QString definingFile(const SourceFile& file, const QString& name,
                     const QMap<QString, int>& definitions) {
    if (definitions.contains(keyOf(file.path, name))) {
        return file.path;
    }
    for (const Include& include : file.includes) {
        if (definitions.contains(keyOf(include.header, name))) {
            return include.header;
        }
    }
    return {};
}

void addMembers(const SourceFile& file, const QMap<QString, int>& definitions,
                QMap<QString, int>& sizes) {
    // "Type Outer::Inner::member(" that begins in the first column.
    static const QRegularExpression member(
        "^(?=[A-Za-z_])(?:.*?[\\s&*])?((?:\\w+::)+)"
        "(?:~?\\w+|operator[^(]*|operator\\(\\))\\(");
    for (qsizetype i = 0; i < file.lines.size(); ++i) {
        const auto match = member.match(file.lines[i]);
        if (!match.hasMatch()) {
            continue;
        }
        for (const QString& name : match.captured(1).split("::", Qt::SkipEmptyParts)) {
            if (const QString path = definingFile(file, name, definitions); !path.isEmpty()) {
                sizes[keyOf(path, name)] += definitionLines(file.lines, i);
                break;
            }
        }
    }
}

}  // namespace

QMap<QString, int> classSizes(const QList<SourceFile>& files) {
    QMap<QString, int> definitions;
    for (const SourceFile& file : files) {
        addDefinitions(file, definitions);
    }
    QMap<QString, int> sizes = definitions;
    for (const SourceFile& file : files) {
        addMembers(file, definitions, sizes);
    }
    return sizes;
}

}  // namespace vybeg::test
