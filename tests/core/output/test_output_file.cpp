#include "core/output/output_file.h"
#include "tests/closeness.h"
#include "tests/core/output/full_disk.h"
#include "tests/small_files.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <csignal>
#include <fcntl.h>
#include <stop_token>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace test_output_file {

using namespace vybeg;
using namespace vybeg::test;

namespace {

QStringList entries(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
}

}  // namespace

class TestOutputFile : public QObject {
    Q_OBJECT

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        QVERIFY(folder_->isValid());
        target_ = folder_->filePath("track.csv");
    }

    void the_target_appears_only_when_committed() {
        QVERIFY(put(target_, "old"));
        {
            auto file = OutputFile::create(target_.toStdString(), {});
            QVERIFY(file);
            QVERIFY(file->write("new"));
            QVERIFY(file->flush());
            QCOMPARE(content(target_), QByteArray("old"));
            QCOMPARE(entries(folder_->path()).size(), 2);
            QVERIFY(file->commit());
            QCOMPARE(content(target_), QByteArray("new"));
        }
        QCOMPARE(content(target_), QByteArray("new"));
        QCOMPARE(entries(folder_->path()), QStringList{"track.csv"});
    }

    void without_commit_nothing_is_left() {
        QVERIFY(put(target_, "old"));
        {
            auto file = OutputFile::create(target_.toStdString(), {});
            QVERIFY(file);
            QVERIFY(file->write(std::string(3 << 20, 'x')));
        }
        QCOMPARE(content(target_), QByteArray("old"));
        QCOMPARE(entries(folder_->path()), QStringList{"track.csv"});
    }

    void what_exceeds_the_buffer_arrives_whole() {
        std::string text;
        auto file = OutputFile::create(target_.toStdString(), {});
        QVERIFY(file);
        for (int i = 0; i < 300000; ++i) {
            const std::string line = std::to_string(i) + "\n";
            text += line;
            QVERIFY(file->write(line));
        }
        QVERIFY(file->commit());
        QVERIFY(content(target_) == QByteArray::fromStdString(text));
    }

    void a_stop_request_leaves_the_old_file() {
        QVERIFY(put(target_, "old"));
        std::stop_source stop;
        {
            auto file = OutputFile::create(target_.toStdString(), JobControl(stop.get_token()));
            QVERIFY(file);
            QVERIFY(file->write("new"));
            stop.request_stop();
            const Status committed = file->commit();
            QVERIFY(!committed);
            QCOMPARE(committed.error().code, ErrorCode::interrupted);
        }
        QCOMPARE(content(target_), QByteArray("old"));
        QCOMPARE(entries(folder_->path()), QStringList{"track.csv"});
    }

    void permissions_of_the_old_file_stay_and_new_ones_follow_the_umask() {
        QVERIFY(put(target_, "old"));
        QCOMPARE(chmod(target_.toUtf8().constData(), 0640), 0);
        const QString other = folder_->filePath("other.csv");
        const mode_t mask = umask(0027);
        for (const QString& path : {target_, other}) {
            auto file = OutputFile::create(path.toStdString(), {});
            QVERIFY(file);
            QVERIFY(file->commit());
        }
        umask(mask);
        struct stat status {};
        QCOMPARE(stat(target_.toUtf8().constData(), &status), 0);
        QCOMPARE(status.st_mode & 0777U, 0640U);
        QCOMPARE(stat(other.toUtf8().constData(), &status), 0);
        QCOMPARE(status.st_mode & 0777U, 0640U);
    }

    void a_link_to_a_file_that_is_to_come_is_followed() {
        const QString link = folder_->filePath("early.csv");
        QVERIFY(QFile::link(folder_->filePath("later.csv"), link));
        auto file = OutputFile::create(link.toStdString(), {});
        QVERIFY(file && file->write("x"));
        QVERIFY(file->commit());
        QVERIFY(QFileInfo(link).isSymLink());
        QCOMPARE(QFileInfo(folder_->filePath("later.csv")).size(), 1);
    }

    void a_link_is_followed() {
        QVERIFY(put(target_, "old"));
        const QString link = folder_->filePath("link.csv");
        QVERIFY(QFile::link(target_, link));
        auto file = OutputFile::create(link.toStdString(), {});
        QVERIFY(file);
        QVERIFY(file->write("new"));
        QVERIFY(file->commit());
        QVERIFY(QFileInfo(link).isSymLink());
        QCOMPARE(content(target_), QByteArray("new"));
    }

    void a_name_as_long_as_the_file_system_allows_can_be_written() {
        const QString longest = folder_->filePath(QString(255, 'n'));
        auto file = OutputFile::create(longest.toStdString(), {});
        QVERIFY(file);
        QVERIFY(file->commit());
        QVERIFY(QFile::exists(longest));
    }

    void a_full_device_is_an_error_and_stays_a_device() {
        auto file = OutputFile::create("/dev/full", {});
        QVERIFY(file);
        QVERIFY(file->write("bytes"));
        const Status committed = file->commit();
        QVERIFY(!committed);
        QCOMPARE(committed.error(),
                 (Error{ErrorCode::output_failed, "/dev/full", {"No space left on device"}}));
        struct stat status {};
        QCOMPARE(stat("/dev/full", &status), 0);
        QVERIFY(S_ISCHR(status.st_mode));
    }

    void a_folder_and_a_missing_folder_are_refused_at_once() {
        const auto folder = OutputFile::create(folder_->path().toStdString(), {});
        QVERIFY(!folder);
        QCOMPARE(folder.error().args[0], std::string("Is a directory"));
        const auto missing =
            OutputFile::create(folder_->filePath("no/track.csv").toStdString(), {});
        QVERIFY(!missing);
        QCOMPARE(missing.error().code, ErrorCode::output_failed);
        QCOMPARE(missing.error().args[0], std::string("No such file or directory"));
    }

    void a_pipe_whose_reader_stands_still_hears_the_stop_request() {
        const QString pipe = folder_->filePath("pipe");
        QCOMPARE(mkfifo(pipe.toUtf8().constData(), 0600), 0);
        const auto unread = OutputFile::create(pipe.toStdString(), {});
        QVERIFY(!unread);  // nobody reads: an error, not a wait for ever
        const int reader = open(pipe.toUtf8().constData(), O_RDONLY | O_NONBLOCK);
        VYBEG_AT_LEAST(reader, 0);
        std::stop_source stop;
        auto file = OutputFile::create(pipe.toStdString(), JobControl(stop.get_token()));
        QVERIFY(file);
        QElapsedTimer timer;
        std::jthread canceller([&] {
            // The writer waits for the pipe's reader as soon as the pipe is full.
            for (int waiting = 0; waiting < fcntl(reader, F_GETPIPE_SZ);) {
                std::this_thread::yield();
                ioctl(reader, FIONREAD, &waiting);
            }
            timer.start();
            stop.request_stop();
        });
        Status written;
        while (written) {
            written = file->write(std::string(1 << 20, 'x'));
        }
        // A part has gone out.
        QCOMPARE(written.error().code, ErrorCode::interrupted_partly);
        canceller.join();
        VYBEG_LESS(timer.elapsed(), 200);
        close(reader);
    }

    void files_of_a_group_appear_together() {
        const QString other = folder_->filePath("other.csv");
        QVERIFY(put(target_, "old"));
        {
            auto one = OutputFile::create(target_.toStdString(), {});
            auto two = OutputFile::create(other.toStdString(), {});
            QVERIFY(one && two);
            QVERIFY(one->write("new"));
            QVERIFY(two->write("new too"));
            QVERIFY(OutputFile::commit_together(std::array{&*one, &*two}));
        }
        QCOMPARE(content(target_), QByteArray("new"));
        QCOMPARE(content(other), QByteArray("new too"));
        QCOMPARE(entries(folder_->path()).size(), 2);
    }

    void where_one_of_a_group_cannot_appear_none_does_data() {
        QTest::addColumn<bool>("first_exists");
        QTest::newRow("an old file") << true;
        QTest::newRow("a new name") << false;
    }

    void where_one_of_a_group_cannot_appear_none_does() {
        QFETCH(bool, first_exists);
        const QString other = folder_->filePath("sub/other.csv");
        QVERIFY(QDir(folder_->path()).mkdir("sub"));
        if (first_exists) {
            QVERIFY(put(target_, "old"));
        }
        {
            auto one = OutputFile::create(target_.toStdString(), {});
            auto two = OutputFile::create(other.toStdString(), {});
            QVERIFY(one && two);
            QVERIFY(one->write("new"));
            QVERIFY(two->write("new too"));
            QVERIFY(QDir(folder_->filePath("sub")).removeRecursively());
            const Status committed = OutputFile::commit_together(std::array{&*one, &*two});
            QVERIFY(!committed);
            QCOMPARE(committed.error(), (Error{ErrorCode::output_failed,
                                               other.toStdString(),
                                               {"No such file or directory"}}));
        }
        QCOMPARE(QFile::exists(target_), first_exists);
        if (first_exists) {
            QCOMPARE(content(target_), QByteArray("old"));
        }
        QCOMPARE(entries(folder_->path()), first_exists ? QStringList{"track.csv"} : QStringList());
    }

    void a_stop_request_leaves_the_whole_group() {
        const QString other = folder_->filePath("other.csv");
        QVERIFY(put(target_, "old"));
        std::stop_source stop;
        {
            const JobControl job(stop.get_token());
            auto one = OutputFile::create(target_.toStdString(), {});
            auto two = OutputFile::create(other.toStdString(), job);
            QVERIFY(one && two);
            QVERIFY(one->write("new"));
            stop.request_stop();
            const Status committed = OutputFile::commit_together(std::array{&*one, &*two});
            QVERIFY(!committed);
            QCOMPARE(committed.error().code, ErrorCode::interrupted);
        }
        QCOMPARE(content(target_), QByteArray("old"));
        QCOMPARE(entries(folder_->path()), QStringList{"track.csv"});
    }

    void a_disk_that_is_full_at_any_size_leaves_the_old_file_data() {
        QTest::addColumn<int>("piece");  // bytes of one write
        QTest::newRow("through the buffer") << 1000;
        QTest::newRow("past the buffer") << (1 << 18);
        QTest::newRow("in one piece") << (3 << 20);
    }

    void a_disk_that_is_full_at_any_size_leaves_the_old_file() {
        QFETCH(int, piece);
        const std::string bytes((3 << 20) + 17, 'x');
        check_full_disk({target_}, 60, [&]() -> Status {
            auto file = OutputFile::create(target_.toStdString(), {});
            if (!file) {
                return file.error();
            }
            Status written;
            for (std::size_t at = 0; at < bytes.size() && written;
                 at += static_cast<std::size_t>(piece)) {
                written = file->write(
                    std::string_view(bytes).substr(at, static_cast<std::size_t>(piece)));
            }
            return written ? file->commit() : written;
        });
    }

    void a_disk_that_is_full_at_any_size_leaves_the_whole_group() {
        const QString other = folder_->filePath("other.csv");
        check_full_disk({target_, other}, 60, [&]() -> Status {
            auto one = OutputFile::create(target_.toStdString(), {});
            auto two = OutputFile::create(other.toStdString(), {});
            if (!one || !two) {
                return one ? two.error() : one.error();
            }
            Status written = one->write(std::string(100'000, 'x'));
            written = written ? two->write(std::string(300'000, 'x')) : written;
            return written ? OutputFile::commit_together(std::array{&*one, &*two}) : written;
        });
    }

    void a_file_from_memory_stands_a_disk_that_is_full_at_any_size() {
        const std::string bytes(100'000, 'x');
        check_full_disk({target_}, 60,
                        [&] { return write_file(target_.toStdString(), bytes, {}); });
    }

    void a_file_is_written_whole() {
        QVERIFY(put(target_, "old"));
        const std::string bytes(5 << 20, 'x');
        QVERIFY(write_file(target_.toStdString(), bytes, {}));
        QVERIFY(content(target_) == QByteArray::fromStdString(bytes));
        QVERIFY(write_file(target_.toStdString(), "", {}));
        QCOMPARE(content(target_), QByteArray());
        QVERIFY(!write_file(folder_->filePath("no/file").toStdString(), bytes, {}));
        const Status full = write_file("/dev/full", bytes, {});
        QVERIFY(!full);
        QCOMPARE(full.error().code, ErrorCode::output_failed);
    }

    void what_went_out_to_a_pipe_is_not_called_unchanged() {
        int ends[2];
        QCOMPARE(pipe(ends), 0);
        std::signal(SIGPIPE, SIG_IGN);
        std::stop_source stop;
        auto file = OutputFile::onto(ends[1], "pipe", JobControl(stop.get_token()));
        const Error interrupted{ErrorCode::interrupted, "", {}};
        QCOMPARE(file.as_it_stands(interrupted), interrupted);
        QVERIFY(file.write("some"));
        QCOMPARE(file.as_it_stands(interrupted), interrupted);
        QVERIFY(file.flush());
        QCOMPARE(file.as_it_stands(interrupted),
                 (Error{ErrorCode::interrupted_partly, "pipe", {}}));
        const Error other{ErrorCode::carrier_not_found, "a", {}};
        QCOMPARE(file.as_it_stands(other), other);
        QVERIFY(file.write("more"));
        close(ends[0]);
        const Status broken = file.commit();
        QVERIFY(!broken);
        QCOMPARE(broken.error(), (Error{ErrorCode::output_incomplete, "pipe", {"Broken pipe"}}));
        close(ends[1]);
    }

private:
    std::unique_ptr<QTemporaryDir> folder_;
    QString target_;
};

VYBEG_TEST(TestOutputFile, threads)

}  // namespace test_output_file

#include "test_output_file.moc"
