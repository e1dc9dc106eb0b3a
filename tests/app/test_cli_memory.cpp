// The memory of an analysis does not grow with its recording: 1 and 5 minutes at 33333 Hz, in
// every format that simulate writes and the raw reader reads; nor does that of a batch with its
// list. tests/benchmarks/README.md, "Long recordings", has the same of one hour.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <vector>

namespace test_cli_memory {

using namespace vybeg::test;

namespace {

// Most memory that one run of vybeg-cli had at any time (ru_maxrss: what VmHWM shows), bytes; -1
// where it did not end with status 0.
qint64 peak_of(const QStringList& arguments) {
    QList<QByteArray> words{VYBEG_CLI};
    for (const QString& argument : arguments) {
        words.append(argument.toLocal8Bit());
    }
    std::vector<char*> argv;
    for (QByteArray& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    pid_t child = 0;
    if (posix_spawn(&child, VYBEG_CLI, nullptr, nullptr, argv.data(), environ) != 0) {
        return -1;
    }
    int status = -1;
    rusage usage{};
    const bool ended = wait4(child, &status, 0, &usage) == child;
    return ended && WIFEXITED(status) && WEXITSTATUS(status) == 0 ? usage.ru_maxrss * 1024 : -1;
}

// Counted piece by piece: a child's peak is at least what its parent has when it starts it.
qint64 lines_of(const QString& path) {
    QFile file(path);
    qint64 lines = 0;
    if (file.open(QIODevice::ReadOnly)) {
        while (!file.atEnd()) {
            lines += file.read(1 << 20).count('\n');
        }
    }
    return lines;
}

}  // namespace

class TestCliMemory : public QObject {
    Q_OBJECT

private slots:
    void memory_does_not_grow_with_the_recording_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("options");
        QTest::newRow("raw") << "run.npy"
                             << "--raw f64 --skip 128 --rate 33333";
        QTest::newRow("NPY") << "run.npy"
                             << "--rate 33333";
        QTest::newRow("WAV") << "run.wav"
                             << "";
        QTest::newRow("CSV") << "run.csv"
                             << "";
    }

    void memory_does_not_grow_with_the_recording() {
        QFETCH(QString, file);
        QFETCH(QString, options);
        const QTemporaryDir folder;
        const QString recording = folder.filePath(file);
        const QString track = folder.filePath("track.csv");
        std::vector<qint64> peaks;
        for (const char* seconds : {"60", "300"}) {
            const Outcome made = run_cli(
                {"simulate", "--demo", "--seconds", seconds, "--tau", "900", "-o", recording},
                folder.path());
            QCOMPARE(made.status, 0);
            peaks.push_back(
                peak_of(QStringList{"analyze", recording, "-o", track, "--window", "60"} +
                        options.split(' ', Qt::SkipEmptyParts)));
            // A row per window of 60 samples, behind the header.
            const qint64 windows = qint64{33333} * QString(seconds).toInt() / 60;
            VYBEG_MORE(lines_of(track), windows);
        }
        qInfo("%.1f MB and %.1f MB", 1e-6 * static_cast<double>(peaks[0]),
              1e-6 * static_cast<double>(peaks[1]));
        VYBEG_MORE(peaks[0], 0);
        VYBEG_MORE(peaks[1], 0);
        VYBEG_LESS(peaks[1], 150'000'000);            // one hour may take 300 MB
        VYBEG_LESS(peaks[1] - peaks[0], 10'000'000);  // the four minutes more are 128 MB of samples
    }

    void nor_with_the_track_s_format_data() {
        QTest::addColumn<QString>("track");
        for (const char* track : {"track.mat", "track.h5", "track.npz"}) {
            QTest::newRow(track) << track;
        }
    }

    void nor_with_the_track_s_format() {
        QFETCH(QString, track);
        const QTemporaryDir folder;
        const QString recording = folder.filePath("run.wav");
        std::vector<qint64> peaks;
        for (const char* seconds : {"20", "200"}) {
            QCOMPARE(run_cli({"simulate", "--demo", "--seconds", seconds, "--tau", "900", "-o",
                              recording},
                             folder.path())
                         .status,
                     0);
            peaks.push_back(
                peak_of({"analyze", recording, "-o", folder.filePath(track), "--window", "6"}));
            // 13 numbers for each window of 6 samples.
            VYBEG_MORE(QFileInfo(folder.filePath(track)).size(),
                       qint64{33333} * QString(seconds).toInt() / 6 * 13 * 8);
        }
        qInfo("%.1f MB and %.1f MB", 1e-6 * static_cast<double>(peaks[0]),
              1e-6 * static_cast<double>(peaks[1]));
        VYBEG_MORE(peaks[0], 0);
        VYBEG_MORE(peaks[1], 0);
        VYBEG_LESS(peaks[1] - peaks[0], 20'000'000);  // the track's numbers alone are 104 MB more
    }

    void nor_does_that_of_an_identification() {
        const QTemporaryDir folder;
        const QString recording = folder.filePath("run.wav");
        std::vector<qint64> peaks;
        // From 250 s on the windows grow instead of their number.
        for (const char* seconds : {"250", "600"}) {
            const Outcome made = run_cli(
                {"simulate", "--demo", "--seconds", seconds, "--tau", "900", "-o", recording},
                folder.path());
            QCOMPARE(made.status, 0);
            peaks.push_back(
                peak_of({"identify", recording, "-o", folder.filePath("resonator.json")}));
        }
        qInfo("%.1f MB and %.1f MB", 1e-6 * static_cast<double>(peaks[0]),
              1e-6 * static_cast<double>(peaks[1]));
        VYBEG_MORE(peaks[0], 0);
        VYBEG_MORE(peaks[1], 0);
        VYBEG_LESS(peaks[1], 150'000'000);
        VYBEG_LESS(peaks[1] - peaks[0], 10'000'000);  // the 350 s more are 187 MB of samples
    }

    void nor_does_that_of_a_batch_with_its_list() {
        const QTemporaryDir folder;
        for (int k = 0; k < 200; ++k) {
            const QString recording = folder.filePath(QString("%1.wav").arg(k));
            if (k < 4) {
                QCOMPARE(run_cli({"simulate", "--seconds", "2", "--noise", "0.001", "--tau", "400",
                                  "--two-theta-A", QString::number(0.4 * k), "-o", recording},
                                 folder.path())
                             .status,
                         0);
            } else {
                QVERIFY(QFile::copy(folder.filePath(QString("%1.wav").arg(k % 4)), recording));
            }
        }
        std::vector<qint64> peaks;
        for (const int recordings : {20, 200}) {
            QByteArray list = "set,file\n";
            for (int k = 0; k < recordings; ++k) {
                list += QString("set %1,%2.wav\n").arg(k / 4).arg(k).toUtf8();
            }
            QVERIFY(put(folder.filePath("list.csv"), list));
            const QString table = folder.filePath("table.csv");
            peaks.push_back(peak_of(
                {"batch", folder.filePath("list.csv"), "-o", table, "--threads", "1", "--quiet"}));
            VYBEG_MORE(lines_of(table), recordings / 4);
            QCOMPARE(content(table).count(",ok,"), recordings / 4);
        }
        qInfo("%.1f MB and %.1f MB", 1e-6 * static_cast<double>(peaks[0]),
              1e-6 * static_cast<double>(peaks[1]));
        VYBEG_MORE(peaks[0], 0);
        VYBEG_MORE(peaks[1], 0);
        VYBEG_LESS(static_cast<double>(peaks[1]), 1.1 * static_cast<double>(peaks[0]));
    }
};

VYBEG_TEST(TestCliMemory, unsanitized)

}  // namespace test_cli_memory

#include "test_cli_memory.moc"
