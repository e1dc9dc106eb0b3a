#include "core/recording/bytes/number_type.h"
#include "core/recording/bytes/sha256.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

namespace test_raw_reader {

using namespace vybeg;
using namespace vybeg::test;

namespace {

std::string encoded(const std::vector<double>& samples, RawType type, bool big_endian) {
    std::string bytes;
    for (const double sample : samples) {
        switch (type) {
            case RawType::i16: bytes += store(static_cast<std::int16_t>(sample), big_endian); break;
            case RawType::i32: bytes += store(static_cast<std::int32_t>(sample), big_endian); break;
            case RawType::f32: bytes += store(static_cast<float>(sample), big_endian); break;
            case RawType::f64: bytes += store(sample, big_endian); break;
        }
    }
    return bytes;
}

OpenOptions raw(RawType type, bool big_endian = false) {
    OpenOptions options{.rate_hz = 20000, .raw = RawLayout{.type = type, .big_endian = big_endian}};
    return options;
}

}  // namespace

class TestRawReader : public QObject {
    Q_OBJECT

private slots:
    void every_type_and_byte_order_gives_back_its_samples_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<bool>("big_endian");
        QTest::addColumn<QString>("format");
        const char* names[] = {"16 bit integer", "32 bit integer", "32 bit float", "64 bit float"};
        for (int type = 0; type < 4; ++type) {
            for (const bool big : {false, true}) {
                const QString text = QString("raw, %1, %2 endian, 2 channels")
                                         .arg(names[type], big ? "big" : "little");
                QTest::newRow(qPrintable(text)) << type << big << text;
            }
        }
    }

    void every_type_and_byte_order_gives_back_its_samples() {
        QFETCH(int, type);
        QFETCH(bool, big_endian);
        QFETCH(QString, format);
        // Long enough for more than one chunk of 1 MiB; whole numbers that every type can hold.
        Samples written;
        std::vector<double> interleaved;
        for (int i = 0; i < 150000; ++i) {
            written.c.push_back(i * 11 % 65536 - 32768);
            written.d.push_back(32767 - 7 * i % 32768);
            interleaved.insert(interleaved.end(), {written.c.back(), written.d.back()});
        }
        const auto raw_type = static_cast<RawType>(type);
        const Folder folder;
        const auto path = folder.write("run", encoded(interleaved, raw_type, big_endian) + "x");
        const Recording recording = opened(path, raw(raw_type, big_endian));
        QCOMPARE(QString::fromStdString(english(recording.format)), format);
        QCOMPARE(recording.rate_hz, 20000.0);
        QCOMPARE(recording.rate_from, RateOrigin::option);
        const Samples read = read_all(recording);
        QCOMPARE(read, written);
        std::vector<double> c(3), d(3);
        QVERIFY(recording.source->read(140000, c, d));
        QVERIFY(std::equal(c.begin(), c.end(), written.c.begin() + 140000));
        QVERIFY(std::equal(d.begin(), d.end(), written.d.begin() + 140000));
    }

    void bytes_have_the_order_that_the_layout_says() {
        const Folder folder;
        const auto path =
            folder.write("run", std::string(4, '\x01') + std::string("\x01\x02\xFF\xFE") +
                                    std::string(12, '\x01'));
        QCOMPARE(read_all(opened(path, raw(RawType::i16, true))).c[1], 0x0102);
        QCOMPARE(read_all(opened(path, raw(RawType::i16, true))).d[1], -2);
        QCOMPARE(read_all(opened(path, raw(RawType::i16, false))).c[1], 0x0201);
        QCOMPARE(read_all(opened(path, raw(RawType::i16, false))).d[1], -257);
    }

    void skipped_bytes_channels_and_scale_are_heeded() {
        std::vector<double> interleaved;
        for (int i = 0; i < 6; ++i) {
            interleaved.insert(interleaved.end(),
                               {1.0 * i, 10.0 * i, i == 3 ? no_value : 100.0 * i});
        }
        const Folder folder;
        const auto path =
            folder.write("run", "header!" + encoded(interleaved, RawType::f64, false));
        OpenOptions options = raw(RawType::f64);
        options.raw->skip_bytes = 7;
        options.raw->channels = 3;
        options.scale = 0.5;
        options.channel_c = 3;
        const Recording recording = opened(path, options);
        QCOMPARE(recording.channels.size(), 3u);
        const Samples read = read_all(recording);
        QCOMPARE(worst_difference(read.c, {0, 50, 100, no_value, 200, 250}), 0.0);
        QCOMPARE(worst_difference(read.d, {0, 5, 10, 15, 20, 25}), 0.0);
    }

    void a_layout_overrides_what_the_file_looks_like() {
        const Folder folder;
        const auto path = folder.write("run.wav", "RIFF....WAVEfmt 1,2\n1,2\n");
        QCOMPARE(opened(path, raw(RawType::i16)).frames(), 6);
    }

    void a_raw_file_without_a_rate_or_samples_is_an_error() {
        const Folder folder;
        const auto path = folder.write("run", std::string(100, 'x'));
        OpenOptions options = raw(RawType::i16);
        options.rate_hz.reset();
        QCOMPARE(open(path, options).error().code, ErrorCode::rate_unknown);
        options = raw(RawType::f64);
        options.raw->skip_bytes = 1000;
        QCOMPARE(open(path, options).error().code, ErrorCode::too_few_frames);
        options.raw->skip_bytes = 1'000'000'000'000'000;
        QCOMPARE(open(path, options).error().code, ErrorCode::too_few_frames);
        options.raw->skip_bytes = std::numeric_limits<std::int64_t>::max();
        QCOMPARE(open(path, options).error().code, ErrorCode::setting_invalid);
        options.raw->skip_bytes = 0;
        options.raw->channels = 1;
        QCOMPARE(open(path, options).error().code, ErrorCode::too_few_channels);
    }

    void a_hash_is_that_of_the_standard_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QByteArray>("hash");
        QTest::newRow("FIPS 180-2, B.1")
            << QByteArray("abc")
            << QByteArray("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        QTest::newRow("FIPS 180-2, B.3: a million times 'a'")
            << QByteArray(1000000, 'a')
            << QByteArray("cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
        QTest::newRow("nothing")
            << QByteArray()
            << QByteArray("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    }

    void a_hash_is_that_of_the_standard() {
        QFETCH(QByteArray, bytes);
        QFETCH(QByteArray, hash);
        const Folder folder;
        const auto found = file_sha256(folder.write("file", bytes.toStdString()), {});
        QVERIFY(found);
        QCOMPARE(*found, hash.toStdString());
        QCOMPARE(file_sha256(folder.file("none"), {}).error().code, ErrorCode::file_missing);
    }

    void hashing_stops_when_it_is_told_to() {
        const Folder folder;
        std::stop_source stop;
        stop.request_stop();
        const auto hash = file_sha256(folder.write("file", "abc"), JobControl(stop.get_token()));
        QVERIFY(!hash);
        QCOMPARE(hash.error().code, ErrorCode::interrupted);
    }
};

VYBEG_TEST(TestRawReader, threads)

}  // namespace test_raw_reader

#include "test_raw_reader.moc"
