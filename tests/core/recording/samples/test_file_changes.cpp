// A recording whose file is no longer what was opened.
#include "core/recording/bytes/sha256.h"
#include "core/recording/samples/recording.h"
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>

namespace test_file_changes {

using namespace vybeg;
using namespace vybeg::test;

class TestFileChanges : public QObject {
    Q_OBJECT

    Folder folder_;

    std::filesystem::path table(const char* name, double amplitude) const {
        std::string text = "C,D\n";
        for (int k = 0; k < 1000; ++k) {
            text += std::to_string(amplitude * std::cos(k)) + "," +
                    std::to_string(amplitude * std::sin(k)) + "\n";
        }
        return folder_.write(name, text);
    }

    static OpenOptions with_rate() {
        OpenOptions options{.rate_hz = 33333};
        return options;
    }

    // A time of the last change that differs whatever the clock's step is.
    static void set_time(const std::filesystem::path& path, long seconds) {
        const timespec times[2]{{seconds, 0}, {seconds, 0}};
        QCOMPARE(utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
    }

private slots:
    void a_file_that_stays_is_unchanged() {
        const auto recording = opened(table("stays.csv", 1), with_rate());
        read_all(recording);
        QVERIFY(unchanged(recording));
        const auto hash = recording_sha256(recording, {});
        QVERIFY(hash);
        QCOMPARE(*hash, *file_sha256(recording.path, {}));
    }

    void a_file_that_grows_is_an_error() {
        const auto recording = opened(table("grows.csv", 1), with_rate());
        struct stat before {};
        QCOMPARE(stat(recording.path.c_str(), &before), 0);
        std::ofstream(recording.path, std::ios::app) << "1,2\n";
        set_time(recording.path, before.st_mtim.tv_sec);
        const Status still = unchanged(recording);
        QVERIFY(!still);
        QCOMPARE(still.error(), (Error{ErrorCode::file_changed, recording.path.string(), {}}));
        QCOMPARE(recording_sha256(recording, {}).error().code, ErrorCode::file_changed);
    }

    void a_file_of_the_same_size_and_another_time_is_an_error() {
        const auto recording = opened(table("other.csv", 1), with_rate());
        std::fstream file(recording.path, std::ios::in | std::ios::out);
        file.seekp(100);
        file << "7";
        file.close();
        set_time(recording.path, 1);
        QCOMPARE(unchanged(recording).error().code, ErrorCode::file_changed);
    }

    void bytes_whose_time_is_put_back_are_an_error() {
        const auto recording = opened(table("back.csv", 1), with_rate());
        struct stat before {};
        QCOMPARE(stat(recording.path.c_str(), &before), 0);
        // A clock tick of the file system, 4 ms, may not have passed.
        QTest::qSleep(20);
        std::fstream file(recording.path, std::ios::in | std::ios::out);
        file.seekp(100);
        file << "7";
        file.close();
        const timespec times[2]{before.st_atim, before.st_mtim};
        QCOMPARE(utimensat(AT_FDCWD, recording.path.c_str(), times, 0), 0);
        QCOMPARE(unchanged(recording).error().code, ErrorCode::file_changed);
        QCOMPARE(recording_sha256(recording, {}).error().code, ErrorCode::file_changed);
    }

    void rights_are_no_bytes() {
        const auto recording = opened(table("rights.csv", 1), with_rate());
        QTest::qSleep(20);
        QCOMPARE(chmod(recording.path.c_str(), 0600), 0);
        QVERIFY(unchanged(recording));
    }

    void the_hash_is_that_of_the_samples_whatever_the_path_names_later() {
        const auto path = table("replaced.csv", 1);
        const auto recording = opened(path, with_rate());
        const std::string before = *file_sha256(path, {});
        std::filesystem::rename(table("new.csv", 2), path);
        QVERIFY(*file_sha256(path, {}) != before);
        const auto hash = recording_sha256(recording, {});
        QVERIFY(hash);
        QCOMPARE(*hash, before);
        QVERIFY(unchanged(recording));
        VYBEG_CLOSE(read_all(recording).c[0], 1, 1e-6);
    }

    void samples_that_come_from_no_file_do_not_change() { QVERIFY(unchanged(Recording{})); }
};

VYBEG_TEST(TestFileChanges)

}  // namespace test_file_changes

#include "test_file_changes.moc"
