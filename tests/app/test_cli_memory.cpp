// The memory of an analysis does not grow with its recording: 1 and 5 minutes at 33333 Hz, in
// every format that simulate writes and the raw reader reads; nor does that of a batch with its
// list. tests/benchmarks/README.md, "Long recordings", has the same of one hour.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <vector>

namespace test_cli_memory {

using namespace vybeg::test;

namespace {

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

class TestCliMemory : public QObject, private CliFolder {
    Q_OBJECT

    // The demonstration of so many seconds, made once for all tests that read it.
    QString demonstration(int seconds, const QString& ending) {
        const QString name = QString("run%1.%2").arg(seconds).arg(ending);
        const QString line = QString("simulate --demo --tau 900 --seconds %1 -o %2");
        if (!QFile::exists(path(name)) && run(line.arg(seconds).arg(name)).status != 0) {
            qFatal("no recording");
        }
        return path(name);
    }

    static qint64 peak_of(const QStringList& arguments) { return used_by(arguments).peak_bytes; }

    // Whether the short and the long run ended well; tells their memory.
    static bool ended(const std::vector<qint64>& peaks) {
        qInfo("%.1f MB and %.1f MB", 1e-6 * static_cast<double>(peaks[0]),
              1e-6 * static_cast<double>(peaks[1]));
        return peaks[0] > 0 && peaks[1] > 0;
    }

private slots:
    void memory_does_not_grow_with_the_recording_data() {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QString>("options");
        QTest::newRow("raw") << "npy"
                             << "--raw f64 --skip 128 --rate 33333";
        QTest::newRow("NPY") << "npy"
                             << "--rate 33333";
        QTest::newRow("WAV") << "wav"
                             << "";
        QTest::newRow("CSV") << "csv"
                             << "";
    }

    void memory_does_not_grow_with_the_recording() {
        QFETCH(QString, ending);
        QFETCH(QString, options);
        const QString track = path("track.csv");
        std::vector<qint64> peaks;
        for (const int seconds : {60, 300}) {
            const QString recording = demonstration(seconds, ending);
            peaks.push_back(
                peak_of(QStringList{"analyze", recording, "-o", track, "--window", "60"} +
                        options.split(' ', Qt::SkipEmptyParts)));
            // A row per window of 60 samples, behind the header.
            const qint64 windows = qint64{33333} * seconds / 60;
            VYBEG_MORE(lines_of(track), windows);
        }
        QVERIFY(ended(peaks));
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
        std::vector<qint64> peaks;
        for (const int seconds : {20, 200}) {
            const QString recording = demonstration(seconds, "wav");
            peaks.push_back(peak_of({"analyze", recording, "-o", path(track), "--window", "6"}));
            // 13 numbers for each window of 6 samples.
            VYBEG_MORE(QFileInfo(path(track)).size(), qint64{33333} * seconds / 6 * 13 * 8);
        }
        QVERIFY(ended(peaks));
        VYBEG_LESS(peaks[1] - peaks[0], 20'000'000);  // the track's numbers alone are 104 MB more
    }

    void nor_does_that_of_an_identification() {
        std::vector<qint64> peaks;
        // From 250 s on the windows grow instead of their number.
        for (const int seconds : {250, 600}) {
            const QString recording = demonstration(seconds, "wav");
            peaks.push_back(peak_of({"identify", recording, "-o", path("resonator.json")}));
        }
        QVERIFY(ended(peaks));
        VYBEG_LESS(peaks[1], 150'000'000);
        VYBEG_LESS(peaks[1] - peaks[0], 10'000'000);  // the 350 s more are 187 MB of samples
    }

    void nor_does_that_of_a_batch_with_its_list() {
        for (int k = 0; k < 200; ++k) {
            const QString recording = path(QString("%1.wav").arg(k));
            if (k < 4) {
                QCOMPARE(run("simulate --seconds 2 --noise 0.001 --tau 400",
                             {"--two-theta-A", QString::number(0.4 * k), "-o", recording})
                             .status,
                         0);
            } else {
                QVERIFY(QFile::copy(path(QString("%1.wav").arg(k % 4)), recording));
            }
        }
        std::vector<qint64> peaks;
        for (const int recordings : {20, 200}) {
            QByteArray list = "set,file\n";
            for (int k = 0; k < recordings; ++k) {
                list += QString("set %1,%2.wav\n").arg(k / 4).arg(k).toUtf8();
            }
            QVERIFY(put(path("list.csv"), list));
            const QString table = path("table.csv");
            peaks.push_back(
                peak_of({"batch", path("list.csv"), "-o", table, "--threads", "1", "--quiet"}));
            VYBEG_MORE(lines_of(table), recordings / 4);
            QCOMPARE(content(table).count(",ok,"), recordings / 4);
        }
        QVERIFY(ended(peaks));
        VYBEG_LESS(static_cast<double>(peaks[1]), 1.1 * static_cast<double>(peaks[0]));
    }
};

VYBEG_TEST(TestCliMemory, unsanitized)

}  // namespace test_cli_memory

#include "test_cli_memory.moc"
