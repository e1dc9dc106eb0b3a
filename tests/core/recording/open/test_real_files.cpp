#include "tests/closeness.h"
#include "tests/core/recording/audio/audio_files.h"
#include "tests/test_registry.h"

namespace test_real_files {

using namespace vybeg;
using namespace vybeg::test;

// Two bell strikes that are not part of the sources: VYBEG_REAL_DATA names their folder.
class TestRealFiles : public QObject {
    Q_OBJECT

private slots:
    void a_real_recording_is_read_as_libsndfile_alone_reads_it_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("format");
        QTest::newRow("kyoto bell") << "kyoto-bell.wav"
                                    << "WAV";
        QTest::newRow("perc bell") << "perc-bell.flac"
                                   << "FLAC";
    }

    void a_real_recording_is_read_as_libsndfile_alone_reads_it() {
        QFETCH(QString, name);
        QFETCH(QString, format);
        const QString folder = qEnvironmentVariable("VYBEG_REAL_DATA");
        if (folder.isEmpty()) {
            qWarning("NOT TESTED: %s. Set VYBEG_REAL_DATA to the folder of the real recordings.",
                     qPrintable(name));
            return;
        }
        const std::filesystem::path path = (folder + "/" + name).toStdString();
        const Recording recording = opened(path);
        QVERIFY(QString::fromStdString(english(recording.format)).startsWith(format));
        QVERIFY(recording.diagnostics.empty());
        const Samples read = read_all(recording);

        SF_INFO info{};
        SNDFILE* file = sf_open(path.c_str(), SFM_READ, &info);
        QVERIFY(file);
        std::vector<double> interleaved(static_cast<std::size_t>(info.frames * info.channels));
        QCOMPARE(sf_readf_double(file, interleaved.data(), info.frames), info.frames);
        sf_close(file);
        QCOMPARE(recording.frames(), info.frames);
        QCOMPARE(recording.rate_hz, static_cast<double>(info.samplerate));
        QCOMPARE(info.channels, 2);
        for (std::size_t i = 0; i < read.c.size(); ++i) {
            VYBEG_EQUAL(read.c[i], interleaved[2 * i]);
            VYBEG_EQUAL(read.d[i], interleaved[2 * i + 1]);
        }
    }
};

VYBEG_TEST(TestRealFiles)

}  // namespace test_real_files

#include "test_real_files.moc"
