#pragma once

#include "tests/small_files.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include <functional>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <vector>

namespace vybeg::test {

// What one run of vybeg-cli left behind.
struct Outcome {
    int status = -1;  // -1: it crashed or did not end within a minute
    QByteArray out;
    QByteArray err;

    QList<QByteArray> err_lines() const {
        QList<QByteArray> lines = err.split('\n');
        lines.removeAll(QByteArray());
        return lines;
    }
};

// `prepare` runs in the child before the program does.
inline Outcome run_program(const QString& program, const QStringList& arguments,
                           const QString& folder, const std::function<void()>& prepare = {}) {
    QProcess process;
    process.setWorkingDirectory(folder);
    if (prepare) {
        process.setChildProcessModifier(prepare);
    }
    process.start(program, arguments);
    Outcome outcome;
    if (process.waitForFinished(60000) && process.exitStatus() == QProcess::NormalExit) {
        outcome.status = process.exitCode();
    }
    outcome.out = process.readAllStandardOutput();
    outcome.err = process.readAllStandardError();
    return outcome;
}

// A limit of the child, soft and hard.
inline std::function<void()> limit(int resource, rlim_t most) {
    return [resource, most] {
        const rlimit both{most, most};
        setrlimit(static_cast<__rlimit_resource>(resource), &both);
    };
}

// Runs the built vybeg-cli in a folder.
inline Outcome run_cli(const QStringList& arguments, const QString& folder) {
    return run_program(VYBEG_CLI, arguments, folder);
}

inline QJsonObject object(const QByteArray& json) {
    return QJsonDocument::fromJson(json).object();
}

inline QJsonObject json_of(const Outcome& outcome) {
    return object(outcome.out);
}

// What one run of vybeg-cli took that ended with status 0: the most memory at any time (ru_maxrss:
// what VmHWM shows) and processor time. Memory of -1: it ended otherwise.
struct Used {
    qint64 peak_bytes = -1;
    double processor_s = 0;
};

inline Used used_by(const QStringList& arguments) {
    QList<QByteArray> texts{VYBEG_CLI};
    for (const QString& argument : arguments) {
        texts.append(argument.toLocal8Bit());
    }
    std::vector<char*> argv;
    for (QByteArray& text : texts) {
        argv.push_back(text.data());
    }
    argv.push_back(nullptr);
    pid_t child = 0;
    if (posix_spawn(&child, VYBEG_CLI, nullptr, nullptr, argv.data(), environ) != 0) {
        return {};
    }
    int status = -1;
    rusage usage{};
    const bool ended = wait4(child, &status, 0, &usage) == child;
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return ended && WIFEXITED(status) && WEXITSTATUS(status) == 0
               ? Used{usage.ru_maxrss * 1024, seconds(usage.ru_utime) + seconds(usage.ru_stime)}
               : Used{};
}

// What stands between the spaces of a command line.
inline QStringList words(const QString& line) {
    return line.split(' ', Qt::SkipEmptyParts);
}

// What the tests of the program share: a folder that it is run in.
class CliFolder {
protected:
    Outcome run(const QStringList& arguments) const { return run_cli(arguments, folder_.path()); }
    Outcome run(const QString& line, const QStringList& more = {}) const {
        return run(words(line) + more);
    }
    Outcome run_here(const QString& program, const QStringList& arguments,
                     const std::function<void()>& prepare = {}) const {
        return run_program(program, arguments, folder_.path(), prepare);
    }
    void start(QProcess& process, const QStringList& arguments) const {
        process.setWorkingDirectory(folder_.path());
        process.start(VYBEG_CLI, arguments);
    }
    QString path(const QString& name) const { return folder_.filePath(name); }
    QByteArray file(const QString& name) const { return content(path(name)); }
    // What an output that was not finished would leave.
    QStringList temporaries() const {
        return QDir(folder_.path()).entryList({".vybeg*"}, QDir::AllEntries | QDir::Hidden);
    }

    QTemporaryDir folder_;
};

}  // namespace vybeg::test
