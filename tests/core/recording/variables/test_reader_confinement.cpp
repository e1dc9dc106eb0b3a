// What vybeg-reader may no longer do when it reads the first byte of a file.
#include "core/recording/variables/library_variables.h"
#include "tests/closeness.h"
#include "tests/core/recording/audio/audio_files.h"
#include "tests/core/recording/demo_files.h"
#include "tests/test_registry.h"

#include <QElapsedTimer>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

namespace test_reader_confinement {

using namespace vybeg;
using namespace vybeg::test;

namespace {

std::string proc_text(pid_t id, const char* name) {
    return bytes_of("/proc/" + std::to_string(id) + "/" + name);
}

// "NoNewPrivs:\t1" of /proc/PID/status as {"NoNewPrivs", "1"}.
std::map<std::string, std::string> status_of(pid_t id) {
    std::map<std::string, std::string> fields;
    std::istringstream lines(proc_text(id, "status"));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(':');
        const std::size_t value = line.find_first_not_of("\t ", colon + 1);
        if (colon != line.npos && value != line.npos) {
            fields[line.substr(0, colon)] = line.substr(value);
        }
    }
    return fields;
}

// The hard limit of a resource, as /proc/PID/limits names it.
std::string hard_limit(pid_t id, const std::string& resource) {
    std::istringstream lines(proc_text(id, "limits"));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(resource)) {
            std::istringstream words(line.substr(resource.size()));
            std::string soft, hard;
            words >> soft >> hard;
            return hard;
        }
    }
    return "not listed";
}

[[maybe_unused]] bool kernel_has_seccomp() {
    return bytes_of("/proc/sys/kernel/seccomp/actions_avail").find("kill_process") !=
           std::string::npos;
}

// Why the list of system calls cannot be tried here; empty where it can.
const char* no_list() {
#ifdef __SANITIZE_ADDRESS__
    return "AddressSanitizer: vybeg-reader runs WITHOUT its list of allowed system calls.";
#else
    return kernel_has_seccomp() ? "" : "This kernel has NO seccomp: vybeg-reader has only limits.";
#endif
}

}  // namespace

class TestReaderConfinement : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        demo_ = demo_second();
        write_with_python(folder_, demo_, plain_and_packed);
        write_audio(folder_.file("run.caf"), demo_, SF_FORMAT_CAF | SF_FORMAT_DOUBLE);
    }

    void a_helper_has_no_privileges_environment_or_resources_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("kind");
        QTest::newRow("HDF5") << "run.h5"
                              << "hdf5";
        QTest::newRow("HDF5, packed") << "packed.h5"
                                      << "hdf5";
        QTest::newRow("MAT 7.3") << "packed.h5"
                                 << "mat73";
        QTest::newRow("audio") << "run.caf"
                               << "audio";
    }

    void a_helper_has_no_privileges_environment_or_resources() {
        QFETCH(QString, file);
        QFETCH(QString, kind);
        const auto process = ReaderProcess::start(file_at(folder_.file(file.toStdString())),
                                                  kind.toStdString(), "X");
        QVERIFY(process);
        // It works: the first sample to be read opens nothing more.
        std::vector<double> samples(33333);
        QVERIFY((*process)->read({0, 0, 0, 33333}, samples));
        QCOMPARE(worst_difference(samples, demo_.c), 0.0);
        const SampleRequest d =
            kind == "audio" ? SampleRequest{0, 1, 0, 33333} : SampleRequest{1, 0, 0, 33333};
        QVERIFY((*process)->read(d, samples));
        QCOMPARE(worst_difference(samples, demo_.d), 0.0);

        const pid_t id = (*process)->id();
        const auto status = status_of(id);
        QCOMPARE(status.at("NoNewPrivs"), std::string("1"));
        QCOMPARE(hard_limit(id, "Max file size"), std::string("0"));
        QCOMPARE(hard_limit(id, "Max processes"), std::string("0"));
        QCOMPARE(hard_limit(id, "Max core file size"), std::string("0"));
        QCOMPARE(hard_limit(id, "Max cpu time"), std::string("36000"));
        if (*no_list() != 0) {
            QSKIP(no_list());
        }
        QCOMPARE(proc_text(id, "environ"), std::string());
        QCOMPARE(hard_limit(id, "Max open files"), std::string("8"));
        QCOMPARE(status.at("Seccomp"), std::string("2"));
    }

    void a_helper_that_does_more_than_read_is_stopped_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("deed");
        for (const char* deed :
             {"open", "write", "pipe", "fork", "connect", "run", "remove", "kill", "code"}) {
            QTest::newRow(deed) << "hdf5" << deed;
        }
        QTest::newRow("audio, open") << "audio"
                                     << "open";
        QTest::newRow("audio, run") << "audio"
                                    << "run";
    }

    void a_helper_that_does_more_than_read_is_stopped() {
        QFETCH(QString, kind);
        QFETCH(QString, deed);
        // The deed itself can be done: only the confinement is in its way.
        QProcess unbound;
        unbound.start(QCoreApplication::applicationDirPath() + "/vybeg-reader-misbehaving", {deed});
        QVERIFY(unbound.waitForFinished(30000));
        QCOMPARE(unbound.exitCode(), 40);

        // Of a file that no library can read, its words about it do not come: it is stopped before.
        const auto file = file_at(folder_.write("hostile", "no recording"));
        const auto start = [&](const QString& what) {
            return ReaderProcess::start(file, (kind + ":" + what).toStdString(), "X",
                                        "vybeg-reader-misbehaving");
        };
        const std::vector<MessageArg> stopped{
            "X", "its library was stopped when it tried to do more than read"};
        const auto harmless = start("nothing");
        QVERIFY(!harmless);
        QVERIFY(harmless.error().args != stopped);
        const auto process = start(deed);
        if (*no_list() != 0) {
            QSKIP(no_list());
        }
        QVERIFY(!process);
        QCOMPARE(process.error().code, ErrorCode::format_damaged);
        QCOMPARE(process.error().args, stopped);
    }

    void without_a_list_nothing_is_read() {
        if (*no_list() != 0) {
            QSKIP(no_list());
        }
        const auto process = ReaderProcess::start(file_at(folder_.file("run.h5")), "hdf5:unlisted",
                                                  "HDF5", "vybeg-reader-misbehaving");
        QVERIFY(!process);
        QCOMPARE(process.error().code, ErrorCode::file_read_failed);
        QCOMPARE(exit_status(process.error().code), 3);
        QVERIFY(english(process.error()).find("seccomp") != std::string::npos);
    }

    void a_helper_may_use_five_seconds_of_processor_time() {
        const auto process = ReaderProcess::start(file_at(folder_.file("run.h5")), "hdf5:spin",
                                                  "HDF5", "vybeg-reader-misbehaving");
        QVERIFY(!process);
        QCOMPARE(process.error().args,
                 (std::vector<MessageArg>{
                     "HDF5", "its library did not come to an end within 5 s of processor time"}));
    }

    void a_helper_that_has_to_wait_is_waited_for() {
        const auto process = ReaderProcess::start(file_at(folder_.file("run.h5")), "hdf5", "HDF5");
        QVERIFY(process);
        const pid_t id = (*process)->id();
        QCOMPARE(::kill(id, SIGSTOP), 0);
        std::thread later([id] {
            // Longer than the processor time that a helper may use.
            std::this_thread::sleep_for(std::chrono::seconds(4));
            ::kill(id, SIGCONT);
        });
        QElapsedTimer timer;
        timer.start();
        std::vector<double> samples(100);
        const Status status = (*process)->read({0, 0, 0, 100}, samples);
        later.join();
        QVERIFY2(status, status ? "" : english(status.error()).c_str());
        VYBEG_AT_LEAST(timer.elapsed(), 3900);
        QCOMPARE(samples[99], demo_.c[99]);
    }

private:
    Folder folder_;
    Samples demo_;
};

VYBEG_TEST(TestReaderConfinement)

}  // namespace test_reader_confinement

#include "test_reader_confinement.moc"
