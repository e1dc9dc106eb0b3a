#pragma once

#include <QProcess>
#include <QRegularExpression>
#include <QStringList>

// What the programs say of themselves, which man pages and completion are compared with.
namespace vybeg::test {

inline QString help_of(const QString& program, const QString& command) {
    QProcess process;
    process.start(program,
                  command.isEmpty() ? QStringList{"--help"} : QStringList{command, "--help"});
    process.waitForFinished();
    return QString::fromUtf8(process.readAllStandardOutput());
}

// What a pattern's only group captures, without repetition, in alphabetical order.
inline QStringList found_in(const QString& text, const QString& pattern) {
    const QRegularExpression expression(pattern, QRegularExpression::MultilineOption);
    QStringList found;
    for (auto matches = expression.globalMatch(text); matches.hasNext();) {
        found += matches.next().captured(1);
    }
    found.removeDuplicates();
    found.sort();
    return found;
}

// The long options that the help describes.
inline QStringList described_options(const QString& help) {
    return found_in(help, "^  (?:-\\w,)?(--[a-zA-Z][-\\w]*)");
}

// The commands of the program: none of the desktop program.
inline QStringList commands_of(const QString& program) {
    return found_in(help_of(program, "").section("Subcommands:\n", 1).section("\n\n", 0, 0),
                    "^  ([a-z][-a-z]*) ");
}

}  // namespace vybeg::test
