#pragma once

#include "core/output/output_file.h"
#include "tests/closeness.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QtTest>

#include <algorithm>
#include <csignal>
#include <functional>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace vybeg::test {

// Lets no file of this process grow beyond a size, as a disk does that is full.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t most) {
        getrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, SIG_IGN);  // write() fails with EFBIG instead
        const rlimit limited{std::min(most, before_.rlim_max), before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limited);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

private:
    rlimit before_{};
};

// Writes files of the same folder with a disk that is full at each of `sizes` sizes from 0 on, and
// at one byte less than the largest file needs. Each time the writer reports that the output cannot
// be written, the old files stay, and no temporary file is left.
inline void check_full_disk(const QStringList& targets, int sizes,
                            const std::function<Status()>& write) {
    const QDir folder = QFileInfo(targets.front()).dir();
    const auto entries = [&] {
        return folder.entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    };
    const Status unlimited = write();
    QVERIFY2(unlimited, unlimited ? "" : unlimited.error().args.front().text.c_str());
    qint64 whole = 0;
    for (const QString& target : targets) {
        whole = std::max(whole, QFileInfo(target).size());
    }
    VYBEG_MORE(whole, sizes);
    std::vector<qint64> most;
    for (int k = 0; k < sizes; ++k) {
        most.push_back(whole * k / sizes);
    }
    most.push_back(whole - 1);
    const QStringList before = entries();
    for (const qint64 bytes : most) {
        for (const QString& target : targets) {
            QFile file(target);
            QVERIFY(file.open(QIODevice::WriteOnly));
            QCOMPARE(file.write("old"), qint64{3});
        }
        Status written;
        {
            const FileSizeLimit limit(static_cast<rlim_t>(bytes));
            written = write();
        }
        const std::string at = std::to_string(bytes) + " bytes";
        QVERIFY2(!written, at.c_str());
        QCOMPARE(written.error().code, ErrorCode::output_failed);
        QCOMPARE(written.error().args, std::vector<MessageArg>{"File too large"});
        for (const QString& target : targets) {
            QFile file(target);
            QVERIFY(file.open(QIODevice::ReadOnly));
            QVERIFY2(file.readAll() == "old", at.c_str());
        }
        QCOMPARE(entries(), before);
    }
}

}  // namespace vybeg::test
