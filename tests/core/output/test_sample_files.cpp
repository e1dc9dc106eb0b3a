// Sample files read back by other people's code (libsndfile, libmatio) or byte by byte.
#include "core/base/number_text.h"
#include "core/output/sample_files.h"
#include "tests/closeness.h"
#include "tests/core/output/full_disk.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <matio.h>
#include <sndfile.h>

#include <cmath>
#include <cstring>
#include <random>
#include <stop_token>

namespace test_sample_files {

using namespace vybeg;
using namespace vybeg::test;

namespace {

struct Signals {
    std::vector<double> c;
    std::vector<double> d;
};

Signals random_signals(std::size_t count) {
    std::mt19937_64 engine(42);
    std::uniform_real_distribution<double> any(-1, 1);
    Signals pair{std::vector<double>(count), std::vector<double>(count)};
    std::ranges::generate(pair.c, [&] { return any(engine); });
    std::ranges::generate(pair.d, [&] { return any(engine); });
    return pair;
}

constexpr std::size_t frames = 70001;  // several blocks and a rest

}  // namespace

class TestSampleFiles : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;
    Signals signals_ = random_signals(frames);

    QString write(const QString& name, int bits = 0, double full_scale = 0) {
        const QString path = folder_.filePath(name);
        const auto format = sample_format(path.toStdString());
        auto file = OutputFile::create(path.toStdString(), {});
        SampleStream stream = in_memory(signals_.c, signals_.d, 33333, {});
        stream.bits = bits;
        stream.full_scale = full_scale;
        if (!format || !file || !write_samples(*file, *format, stream) || !file->commit()) {
            return "(not written)";
        }
        return path;
    }

    static QByteArray content(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private slots:
    void the_ending_decides() {
        QCOMPARE(*sample_format("a.wav"), SampleFormat::wav);
        QCOMPARE(*sample_format("/x.y/a.CSV"), SampleFormat::csv);
        QCOMPARE(*sample_format("a.b.Npy"), SampleFormat::npy);
        QCOMPARE(*sample_format("a.mat"), SampleFormat::mat);
        for (const char* name : {"a", "a.txt", "wav", "a.wav.gz"}) {
            const auto format = sample_format(name);
            QVERIFY(!format);
            QCOMPARE(format.error().code, ErrorCode::output_format_unknown);
        }
        QCOMPARE(sample_format("a.txt").error().args[0], std::string(".txt"));
    }

    void a_disk_that_is_full_at_any_size_leaves_the_old_file_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"full.wav", "full.csv", "full.npy", "full.mat"}) {
            QTest::newRow(name) << name;
        }
    }

    void a_disk_that_is_full_at_any_size_leaves_the_old_file() {
        QFETCH(QString, name);
        const std::string target = folder_.filePath(name).toStdString();
        check_full_disk({folder_.filePath(name)}, 15, [&]() -> Status {
            auto file = OutputFile::create(target, {});
            if (!file) {
                return file.error();
            }
            const Status written = write_samples(*file, *sample_format(target),
                                                 in_memory(signals_.c, signals_.d, 33333, {}));
            return written ? file->commit() : written;
        });
    }

    void wav_keeps_every_bit() {
        SF_INFO info{};
        SNDFILE* const wav = sf_open(qPrintable(write("a.wav")), SFM_READ, &info);
        QVERIFY(wav);
        QCOMPARE(info.format, SF_FORMAT_WAV | SF_FORMAT_DOUBLE);
        QCOMPARE(info.samplerate, 33333);
        QCOMPARE(info.channels, 2);
        QCOMPARE(info.frames, sf_count_t{frames});
        std::vector<double> read(2 * frames);
        QCOMPARE(sf_readf_double(wav, read.data(), info.frames), info.frames);
        sf_close(wav);
        for (std::size_t k = 0; k < frames; ++k) {
            QCOMPARE(read[2 * k], signals_.c[k]);
            QCOMPARE(read[2 * k + 1], signals_.d[k]);
        }
    }

    void the_same_samples_give_the_same_bytes() {
        const QByteArray first = content(write("a.wav"));
        // A time stamp in seconds would differ.
        const qint64 second = QDateTime::currentSecsSinceEpoch();
        QTRY_VERIFY(QDateTime::currentSecsSinceEpoch() > second);
        QVERIFY(first == content(write("b.wav")));
        QVERIFY(!first.isEmpty());
    }

    void wav_with_bits_is_pcm_of_the_next_width_data() {
        QTest::addColumn<int>("bits");
        QTest::addColumn<int>("subtype");
        QTest::newRow("8") << 8 << int{SF_FORMAT_PCM_U8};
        QTest::newRow("12") << 12 << int{SF_FORMAT_PCM_16};
        QTest::newRow("16") << 16 << int{SF_FORMAT_PCM_16};
        QTest::newRow("24") << 24 << int{SF_FORMAT_PCM_24};
        QTest::newRow("32") << 32 << int{SF_FORMAT_PCM_32};
    }

    void wav_with_bits_is_pcm_of_the_next_width() {
        QFETCH(int, bits);
        QFETCH(int, subtype);
        const double full_scale = 2.5;
        const double steps = std::ldexp(1.0, bits - 1);
        for (std::vector<double>* channel : {&signals_.c, &signals_.d}) {
            for (double& sample : *channel) {
                sample = std::round(sample / full_scale * steps) / steps * full_scale;
            }
        }
        signals_.c[0] = -full_scale;
        signals_.c[1] = full_scale * (steps - 1) / steps;
        SF_INFO info{};
        SNDFILE* const wav =
            sf_open(qPrintable(write("pcm.wav", bits, full_scale)), SFM_READ, &info);
        QVERIFY(wav);
        QCOMPARE(info.format, SF_FORMAT_WAV | subtype);
        std::vector<double> read(2 * frames);
        QCOMPARE(sf_readf_double(wav, read.data(), info.frames), sf_count_t{frames});
        sf_close(wav);
        for (std::size_t k = 0; k < frames; ++k) {
            VYBEG_CLOSE(read[2 * k], signals_.c[k] / full_scale, 1e-3 / steps);
            VYBEG_CLOSE(read[2 * k + 1], signals_.d[k] / full_scale, 1e-3 / steps);
        }
    }

    void csv_holds_time_and_both_signals_to_the_last_bit() {
        const QList<QByteArray> lines = content(write("a.csv")).split('\n');
        QCOMPARE(lines.size(), qsizetype{frames} + 2);
        QCOMPARE(lines.front(), QByteArray("t_s,C,D"));
        QCOMPARE(lines.back(), QByteArray());
        for (std::size_t k = 0; k < frames; ++k) {
            const QList<QByteArray> fields = lines[static_cast<qsizetype>(k) + 1].split(',');
            QCOMPARE(fields.size(), 3);
            QCOMPARE(parse_number(fields[0].toStdString()), static_cast<double>(k) / 33333);
            QCOMPARE(parse_number(fields[1].toStdString()), signals_.c[k]);
            QCOMPARE(parse_number(fields[2].toStdString()), signals_.d[k]);
        }
    }

    void npy_is_version_1_with_two_columns_of_doubles() {
        const QByteArray bytes = content(write("a.npy"));
        QCOMPARE(bytes.first(8), QByteArray("\x93NUMPY\x01\x00", 8));
        const int length = static_cast<uchar>(bytes[8]) + 256 * static_cast<uchar>(bytes[9]);
        QCOMPARE((10 + length) % 64, 0);
        const QByteArray dictionary = bytes.mid(10, length);
        QVERIFY(dictionary.startsWith(
            "{'descr': '<f8', 'fortran_order': False, 'shape': (70001, 2), }"));
        QVERIFY(dictionary.endsWith('\n'));
        QCOMPARE(bytes.size(), 10 + length + qsizetype{frames} * 16);
        for (std::size_t k = 0; k < frames; ++k) {
            double row[2];
            std::memcpy(row, bytes.constData() + 10 + length + 16 * k, sizeof row);
            QCOMPARE(row[0], signals_.c[k]);
            QCOMPARE(row[1], signals_.d[k]);
        }
    }

    void mat_is_read_by_libmatio() {
        mat_t* const mat = Mat_Open(qPrintable(write("a.mat")), MAT_ACC_RDONLY);
        QVERIFY(mat);
        QCOMPARE(Mat_GetVersion(mat), MAT_FT_MAT5);
        for (const auto& [name, values] : {std::pair{"S_C", &signals_.c}, {"S_D", &signals_.d}}) {
            matvar_t* const variable = Mat_VarRead(mat, name);
            QVERIFY(variable);
            QCOMPARE(variable->class_type, MAT_C_DOUBLE);
            QCOMPARE(variable->dims[0], frames);
            QCOMPARE(variable->dims[1], std::size_t{1});
            QVERIFY(std::memcmp(variable->data, values->data(), frames * sizeof(double)) == 0);
            Mat_VarFree(variable);
        }
        matvar_t* const rate = Mat_VarRead(mat, "fs");
        QVERIFY(rate);
        QCOMPARE(*static_cast<double*>(rate->data), 33333.0);
        Mat_VarFree(rate);
        std::size_t variables = 0;
        QVERIFY(Mat_GetDir(mat, &variables));
        QCOMPARE(variables, std::size_t{3});
        Mat_Close(mat);
    }

    void a_rate_that_is_not_whole_does_not_fit_into_wav() {
        const QString path = folder_.filePath("rate.wav");
        auto file = OutputFile::create(path.toStdString(), {});
        QVERIFY(file);
        const Status written =
            write_samples(*file, SampleFormat::wav, in_memory(signals_.c, signals_.d, 33333.5, {}));
        QVERIFY(!written);
        QCOMPARE(written.error().code, ErrorCode::output_failed);
    }

    void a_full_device_is_an_error_in_every_format_data() {
        QTest::addColumn<SampleFormat>("format");
        QTest::newRow("wav") << SampleFormat::wav;
        QTest::newRow("csv") << SampleFormat::csv;
        QTest::newRow("npy") << SampleFormat::npy;
        QTest::newRow("mat") << SampleFormat::mat;
    }

    void a_full_device_is_an_error_in_every_format() {
        QFETCH(SampleFormat, format);
        auto file = OutputFile::create("/dev/full", {});
        QVERIFY(file);
        const Status written =
            write_samples(*file, format, in_memory(signals_.c, signals_.d, 33333, {}));
        QVERIFY(!written);
        QCOMPARE(written.error().code, ErrorCode::output_failed);
    }

    void a_stop_request_is_heard_in_every_format_data() {
        a_full_device_is_an_error_in_every_format_data();
    }

    void a_stop_request_is_heard_in_every_format() {
        QFETCH(SampleFormat, format);
        std::stop_source stop;
        const JobControl job(stop.get_token());
        auto file = OutputFile::create(folder_.filePath("stopped").toStdString(), job);
        QVERIFY(file);
        stop.request_stop();
        const Status written =
            write_samples(*file, format, in_memory(signals_.c, signals_.d, 33333, job));
        QVERIFY(!written);
        QCOMPARE(written.error().code, ErrorCode::interrupted);
    }
};

VYBEG_TEST(TestSampleFiles, threads)

}  // namespace test_sample_files

#include "test_sample_files.moc"
