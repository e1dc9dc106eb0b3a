#include "core/recording/variables/library_variables.h"
#include "tests/closeness.h"
#include "tests/core/recording/demo_files.h"
#include "tests/test_registry.h"

#include <QElapsedTimer>

#include <atomic>
#include <csignal>
#include <fstream>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace test_reader_process {

using namespace vybeg;
using namespace vybeg::test;

namespace {

// The processes that this one has started and not yet taken leave of.
std::vector<pid_t> helpers() {
    std::vector<pid_t> found;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::ifstream list(task.path() / "children");
        for (pid_t id = 0; list >> id;) {
            found.push_back(id);
        }
    }
    return found;
}

}  // namespace

class TestReaderProcess : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        demo_ = demo_second();
        write_with_python(folder_, demo_, plain_and_packed);
    }

    void a_catalogue_and_an_error_survive_the_wire() {
        const Catalogue catalogue{"HDF5",
                                  "2020-09-01",
                                  {{"/C", 100, 2, "64 bit float", "", "V", {}, 1000.0},
                                   {"/fs", 1, 1, "16 bit integer", "", "", 5.0, {}},
                                   {"/z", 7, 1, "", "complex numbers", "", {}, {}}},
                                  true};
        const auto decoded = decode_catalogue(encode(catalogue));
        QVERIFY(decoded);
        QVERIFY(*decoded == catalogue);

        const Error error{ErrorCode::format_damaged, "", {"HDF5", "a reason"}};
        QVERIFY(decode_error(encode(error)) == error);
        // The helper has no say in what else is wrong with the program.
        QVERIFY(!decode_error(encode(Error{ErrorCode::interrupted, "", {}})));
        QVERIFY(!decode_error(encode(Error{ErrorCode::format_damaged, "", {"HDF5"}})));
    }

    void a_message_cut_anywhere_is_no_message() {
        const Catalogue catalogue{
            "HDF5", "", {{"/C", 100, 2, "64 bit float", "", "V", {}, 1000.0}}};
        const std::string bytes = encode(catalogue);
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            QVERIFY(!decode_catalogue(std::string_view(bytes).substr(0, length)));
        }
        std::string huge = bytes;
        huge.replace(0, 8, 8, '\xFF');
        QVERIFY(!decode_catalogue(huge));
        Catalogue negative = catalogue;
        negative.variables[0].frames = -1;
        QVERIFY(!decode_catalogue(encode(negative)));
    }

    void only_requests_for_what_is_there_fit() {
        Catalogue catalogue{"HDF5", "", {{"/C", 100, 2, "", "", "", {}, {}}}};
        constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
        QVERIFY(fits({0, 1, 90, 10}, catalogue));
        QVERIFY(!fits({0, 1, 90, 11}, catalogue));
        QVERIFY(!fits({0, 1, 90, most}, catalogue));
        QVERIFY(!fits({0, 1, -1, 5}, catalogue));
        QVERIFY(!fits({0, 1, 0, -1}, catalogue));
        QVERIFY(!fits({0, 2, 0, 10}, catalogue));
        QVERIFY(!fits({1, 0, 0, 10}, catalogue));
        QVERIFY(!fits({-1, 0, 0, 10}, catalogue));
        catalogue.variables[0].unsupported = "complex numbers";
        QVERIFY(!fits({0, 1, 90, 10}, catalogue));
    }

    void a_helper_that_dies_is_damage_and_nothing_more() {
        const auto file = file_at(folder_.file("run.h5"));
        auto process = ReaderProcess::start(file, "hdf5", "HDF5");
        QVERIFY(process);
        std::vector<double> samples(100);
        QVERIFY((*process)->read({0, 0, 0, 100}, samples));
        QCOMPARE(samples[99], demo_.c[99]);
        // As a library's crash ends it; the place in its conversation does not matter.
        QCOMPARE(::kill((*process)->id(), SIGSEGV), 0);
        const Status status = (*process)->read({0, 0, 0, 100}, samples);
        QVERIFY(!status);
        QCOMPARE(status.error().code, ErrorCode::format_damaged);
        QCOMPARE(status.error().args,
                 (std::vector<MessageArg>{"HDF5", "its library failed on it"}));
        QCOMPARE(exit_status(status.error().code), 3);
    }

    void a_helper_that_stops_working_is_given_up_after_twenty_seconds() {
        const auto file = file_at(folder_.file("run.h5"));
        auto process = ReaderProcess::start(file, "hdf5", "HDF5");
        QVERIFY(process);
        const pid_t id = (*process)->id();
        QCOMPARE(::kill(id, SIGSTOP), 0);
        QElapsedTimer timer;
        timer.start();
        std::vector<double> samples(100);
        const Status status = (*process)->read({0, 0, 0, 100}, samples);
        QVERIFY(!status);
        VYBEG_AT_LEAST(timer.elapsed(), 19000);
        VYBEG_LESS(timer.elapsed(), 60000);
        QCOMPARE(status.error().args,
                 (std::vector<MessageArg>{"HDF5", "its library stopped working on it for 20 s"}));
        QCOMPARE(::kill(id, 0), -1);  // a stopped one is ended, too
    }

    void a_recording_outlives_its_helper() {
        const Recording recording = opened(folder_.file("packed.h5"));
        QCOMPARE(helpers().size(), 1u);
        QCOMPARE(::kill(helpers()[0], SIGKILL), 0);
        std::vector<double> c(10), d(10);
        const Status status = recording.source->read(5000, c, d);
        QVERIFY(!status);
        QCOMPARE(status.error().code, ErrorCode::format_damaged);
        QVERIFY(recording.source->read(5000, c, d));
        QCOMPARE(d[0], demo_.d[5000]);
    }

    void no_helper_outlives_its_recording() {
        {
            const Recording first = opened(folder_.file("run.h5"));
            const Recording second = opened(folder_.file("packed.h5"));
            QCOMPARE(helpers().size(), 2u);
        }
        QVERIFY(helpers().empty());
        const OpenOptions options{.variables = {"none"}};
        QVERIFY(!open(folder_.file("run.h5"), options));
        QVERIFY(helpers().empty());
    }

    void a_recording_is_read_from_several_threads() {
        const Recording recording = opened(folder_.file("packed.h5"));
        std::atomic<int> wrong = 0;
        std::vector<std::thread> threads;
        for (int thread = 0; thread < 4; ++thread) {
            threads.emplace_back([&, thread] {
                std::vector<double> c(50), d(50);
                for (std::size_t i = 0; i < 100; ++i) {
                    const std::size_t first =
                        (i * 331 + static_cast<std::size_t>(thread) * 7919) % 33000;
                    const bool read = static_cast<bool>(
                        recording.source->read(static_cast<std::int64_t>(first), c, d));
                    wrong += !read || c[49] != demo_.c[first + 49] || d[0] != demo_.d[first];
                }
            });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        QCOMPARE(wrong.load(), 0);
    }

    void the_helper_alone_does_nothing() {
        QProcess helper;
        helper.start(QCoreApplication::applicationDirPath() + "/vybeg-reader", QStringList());
        QVERIFY(helper.waitForFinished(10000));
        QCOMPARE(helper.exitCode(), 2);
        QVERIFY(helper.readAllStandardError().contains("started by vybeg"));
    }

private:
    Folder folder_;
    Samples demo_;
};

VYBEG_TEST(TestReaderProcess)

}  // namespace test_reader_process

#include "test_reader_process.moc"
