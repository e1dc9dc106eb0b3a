#include "core/recording/bytes/number_type.h"
#include "tests/closeness.h"
#include "tests/core/recording/audio/audio_files.h"
#include "tests/test_registry.h"

#include <cmath>
#include <cstring>
#include <thread>

namespace test_audio_reader {

using namespace vybeg;
using namespace vybeg::test;

class TestAudioReader : public QObject {
    Q_OBJECT

private slots:
    void every_container_and_sample_type_gives_back_its_samples_data() {
        QTest::addColumn<int>("format");
        QTest::addColumn<double>("tolerance");  // half a count of the sample type, full scale 1
        QTest::addColumn<QString>("description");
        struct Container {
            const char* name;
            int code;
        };
        struct Type {
            const char* name;
            int code;
            double tolerance;
        };
        const Container containers[] = {{"WAV", SF_FORMAT_WAV},
                                        {"RF64", SF_FORMAT_RF64},
                                        {"W64", SF_FORMAT_W64},
                                        {"AIFF", SF_FORMAT_AIFF},
                                        {"CAF", SF_FORMAT_CAF},
                                        {"WAVEX", SF_FORMAT_WAVEX},
                                        {"AU", SF_FORMAT_AU},
                                        {"FLAC", SF_FORMAT_FLAC},
                                        {"WAV", SF_FORMAT_WAV | SF_ENDIAN_BIG}};
        // libsndfile scales by 2^(bits-1) - 1 when it writes and by 2^(bits-1) when it reads: one
        // count.
        const Type types[] = {{"Signed 16 bit PCM", SF_FORMAT_PCM_16, 1.6 * 0x1p-15},
                              {"Signed 24 bit PCM", SF_FORMAT_PCM_24, 1.6 * 0x1p-23},
                              {"Signed 32 bit PCM", SF_FORMAT_PCM_32, 1.6 * 0x1p-31},
                              {"32 bit float", SF_FORMAT_FLOAT, 0x1p-24},
                              {"64 bit float", SF_FORMAT_DOUBLE, 0}};
        int rows = 0;
        for (const Container& container : containers) {
            for (const Type& type : types) {
                SF_INFO info{};
                info.samplerate = 33333;
                info.channels = 2;
                info.format = container.code | type.code;
                if (sf_format_check(&info)) {
                    const QString text =
                        QString("%1, %2, 2 channels").arg(container.name, type.name);
                    QTest::addRow("%s %d", qPrintable(text), rows++)
                        << info.format << type.tolerance << text;
                }
            }
        }
        QCOMPARE(rows, 8 * 5 + 2);  // FLAC has 16 and 24 bit alone
    }

    void every_container_and_sample_type_gives_back_its_samples() {
        QFETCH(int, format);
        QFETCH(double, tolerance);
        QFETCH(QString, description);
        const Folder folder;
        const Samples written = wave(5000);
        write_audio(folder.file("run"), written, format);
        const Recording recording = opened(folder.file("run"));
        QCOMPARE(recording.frames(), 5000);
        QCOMPARE(recording.rate_hz, 33333.0);
        QCOMPARE(recording.rate_from, RateOrigin::file);
        QCOMPARE(QString::fromStdString(english(recording.format)), description);
        QCOMPARE(recording.channels, (std::vector<Channel>{{"1", ""}, {"2", ""}}));
        QVERIFY(recording.diagnostics.empty());
        const Samples read = read_all(recording);
        VYBEG_WITHIN(worst_difference(read.c, written.c), 0, tolerance);
        VYBEG_WITHIN(worst_difference(read.d, written.d), 0, tolerance);

        // The same from the middle, after having been at the end.
        std::vector<double> c(100), d(100);
        QVERIFY(recording.source->read(1234, c, d));
        QVERIFY(std::equal(c.begin(), c.end(), read.c.begin() + 1234));
        QVERIFY(std::equal(d.begin(), d.end(), read.d.begin() + 1234));
    }

    void float_samples_come_through_to_the_last_bit_and_beyond_full_scale() {
        const Folder folder;
        const Samples written{{1.0 / 3, -7.25, 1e-300, 1234567.0, 0}, {2, 3, 4, 5, 0.1}};
        write_audio(folder.file("run.wav"), written, SF_FORMAT_WAV | SF_FORMAT_DOUBLE);
        const Samples read = read_all(opened(folder.file("run.wav")));
        QCOMPARE(read, written);
    }

    void nan_and_infinite_samples_are_missing_samples() {
        const Folder folder;
        const double infinity = std::numeric_limits<double>::infinity();
        write_audio(folder.file("run.wav"),
                    {{1, no_value, 3, -infinity, 5}, {1, 2, infinity, 4, no_value}},
                    SF_FORMAT_WAV | SF_FORMAT_DOUBLE);
        const Samples read = read_all(opened(folder.file("run.wav")));
        QCOMPARE(worst_difference(read.c, {1, no_value, 3, no_value, 5}), 0.0);
        QCOMPARE(worst_difference(read.d, {1, 2, no_value, 4, no_value}), 0.0);
    }

    void content_decides_and_the_name_does_not() {
        const Folder folder;
        write_audio(folder.file("run.csv"), wave(50), SF_FORMAT_FLAC | SF_FORMAT_PCM_16);
        QCOMPARE(opened(folder.file("run.csv")).format.front(), FormatPart::name("FLAC"));
        const auto text = folder.write("run.wav", "1,2\n3,4\n5,6\n7,8\n9,10\n");
        const OpenOptions options{.rate_hz = 1000};
        QCOMPARE(english(opened(text, options).format), std::string("text, 2 columns, comma"));
    }

    void flac_behind_a_tag_of_any_length_is_read() {
        const Folder folder;
        write_audio(folder.file("run.flac"), wave(5000), SF_FORMAT_FLAC | SF_FORMAT_PCM_16);
        const std::string flac = bytes_of(folder.file("run.flac"));
        const Samples expected = read_all(opened(folder.file("run.flac")));
        for (const int length : {0, 200, 100000}) {  // the last one beyond what tells the format
            std::string tag("ID3\x04\0\0", 6);
            for (const int shift : {21, 14, 7, 0}) {
                tag += static_cast<char>((length >> shift) & 0x7F);
            }
            tag.resize(tag.size() + static_cast<std::size_t>(length), '\0');
            const Recording recording = opened(folder.write("tagged.flac", tag + flac));
            QCOMPARE(recording.format.front(), FormatPart::name("FLAC"));
            QCOMPARE(read_all(recording), expected);
        }
    }

    void integers_of_more_than_32_bits_are_read_or_a_limit_data() {
        QTest::addColumn<int>("bits");
        for (const int bits : {36, 40, 48, 64}) {
            QTest::addRow("%d bits", bits) << bits;
        }
    }

    void integers_of_more_than_32_bits_are_read_or_a_limit() {
        QFETCH(int, bits);
        const auto little = [](std::uint64_t value, int bytes) {
            std::string text;
            for (int i = 0; i < bytes; ++i) {
                text += static_cast<char>(value >> (8 * i));
            }
            return text;
        };
        const int width = (bits + 7) / 8;
        const std::string format = little(1, 2) + little(2, 2) + little(33333, 4) +
                                   little(static_cast<std::uint64_t>(33333 * 2 * width), 4) +
                                   little(static_cast<std::uint64_t>(2 * width), 2) +
                                   little(static_cast<std::uint64_t>(bits), 2);
        const std::string samples(static_cast<std::size_t>(100 * 2 * width), '\1');
        const std::string chunks = "WAVEfmt " + little(format.size(), 4) + format + "data" +
                                   little(samples.size(), 4) + samples;
        const Folder folder;
        const auto wrong =
            open(folder.write("run.wav", "RIFF" + little(chunks.size(), 4) + chunks));
        if (bits == 64) {
            QVERIFY(wrong);
            QCOMPARE(wrong->frames(), 100);
            QCOMPARE(read_all(*wrong).c,
                     std::vector<double>(100, static_cast<double>(0x0101010101010101) * 0x1p-63));
            return;
        }
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().code, ErrorCode::format_limit);
        QCOMPARE(english(wrong.error().args.at(1)), "integers of " + std::to_string(bits) +
                                                        " bits; up to 32, and 64 in WAV, are read");
    }

    void rates_with_a_fraction_and_open_ends_are_read() {
        const Folder folder;
        const auto written = [&folder](int format) {
            write_audio(folder.file("run"), wave(5000), format);
            return bytes_of(folder.file("run"));
        };
        std::string aiff = written(SF_FORMAT_AIFF | SF_FORMAT_PCM_16);
        aiff.replace(aiff.find("COMM") + 16, 10,
                     store(std::uint16_t{16383 + 15}, true) +
                         store(static_cast<std::uint64_t>(std::ldexp(33333.5, 48)), true));
        QCOMPARE(opened(folder.write("fraction.aiff", aiff)).rate_hz, 33333.5);

        std::string caf = written(SF_FORMAT_CAF | SF_FORMAT_DOUBLE);
        caf.replace(20, 8, store(16000.25, true));
        caf.replace(caf.find("data") + 4, 8, store(std::int64_t{-1}, true));
        const Recording open_caf = opened(folder.write("open.caf", caf));
        QCOMPARE(open_caf.rate_hz, 16000.25);
        QCOMPARE(open_caf.frames(), 5000);
        QVERIFY(open_caf.diagnostics.empty());

        std::string flac = written(SF_FORMAT_FLAC | SF_FORMAT_PCM_16);
        flac[21] = static_cast<char>(flac[21] & 0xF0);
        flac.replace(22, 4, std::string(4, '\0'));
        const Recording open_flac = opened(folder.write("open.flac", flac));
        QCOMPARE(open_flac.frames(), 5000);
        QVERIFY(open_flac.diagnostics.empty());
    }

    void chunks_of_other_containers_mean_nothing() {
        const Folder folder;
        write_audio(folder.file("run.wav"), wave(50), SF_FORMAT_WAV | SF_FORMAT_PCM_16);
        const std::string wav = bytes_of(folder.file("run.wav"));
        const Samples expected = read_all(opened(folder.file("run.wav")));
        for (const char* name : {"desc", "COMM", "ds64"}) {
            std::string with = wav;
            with.insert(wav.find("data"),
                        name + std::string("\x18\0\0\0", 4) + std::string(24, '\0'));
            with.replace(4, 4, store(static_cast<std::uint32_t>(with.size() - 8), false));
            QCOMPARE(read_all(opened(folder.write("with.wav", with))).c, expected.c);
        }
    }

    void a_scale_gives_the_samples_their_unit() {
        const Folder folder;
        write_audio(folder.file("run.wav"), wave(70000), SF_FORMAT_WAV | SF_FORMAT_PCM_24);
        const OpenOptions options{.unit = "V", .scale = 2.5};
        const Recording scaled = opened(folder.file("run.wav"), options);
        Samples expected = read_all(opened(folder.file("run.wav")));
        for (std::vector<double>* values : {&expected.c, &expected.d}) {
            for (double& value : *values) {
                value *= 2.5;
            }
        }
        QCOMPARE(read_all(scaled), expected);
        QCOMPARE(scaled.channels[0].unit, std::string("V"));
        QCOMPARE(scaled.read_with, std::string("--scale 2.5 --unit V"));
    }

    void any_two_channels_can_be_c_and_d_in_any_order() {
        const Folder folder;
        const Samples written = wave(20);
        write_audio(folder.file("run.wav"), written, SF_FORMAT_WAV | SF_FORMAT_DOUBLE, 1000, 4);
        OpenOptions options{.channel_c = 2, .channel_d = 1};
        const Recording swapped = opened(folder.file("run.wav"), options);
        QCOMPARE(swapped.channels.size(), 4u);
        QCOMPARE(swapped.channel_c, 2);
        QCOMPARE(swapped.channel_d, 1);
        QCOMPARE(read_all(swapped).c, written.d);
        QCOMPARE(read_all(swapped).d, written.c);
        options.channel_d = 4;
        QCOMPARE(read_all(opened(folder.file("run.wav"), options)).d, std::vector<double>(20, 0.0));
    }

    void the_rate_of_the_file_wins_over_the_option() {
        const Folder folder;
        write_audio(folder.file("run.wav"), wave(20), SF_FORMAT_WAV | SF_FORMAT_PCM_16, 48000);
        const OpenOptions options{.rate_hz = 1000};
        const Recording recording = opened(folder.file("run.wav"), options);
        QCOMPARE(recording.rate_hz, 48000.0);
        QCOMPARE(recording.rate_from, RateOrigin::file);
    }

    void a_file_whose_header_gives_rate_zero_takes_the_rate_of_the_option() {
        const Folder folder;
        const Samples written = wave(20);
        for (const int container : {SF_FORMAT_WAV, SF_FORMAT_W64}) {
            write_audio(folder.file("run"), written, container | SF_FORMAT_DOUBLE);
            std::string bytes = bytes_of(folder.file("run"));
            const std::size_t format = bytes.find("fmt ");
            const std::size_t rate_at = format + (container == SF_FORMAT_WAV ? 8 : 24) + 4;
            bytes.replace(rate_at, 4, 4, '\0');
            const auto path = folder.write("rateless", bytes);
            const auto without = open(path);
            QVERIFY(!without);
            QCOMPARE(without.error().code, ErrorCode::rate_unknown);
            const OpenOptions options{.rate_hz = 1234.5};
            const Recording recording = opened(path, options);
            QCOMPARE(recording.rate_hz, 1234.5);
            QCOMPARE(recording.rate_from, RateOrigin::option);
            QCOMPARE(read_all(recording).c, written.c);
        }
    }

    void the_date_of_the_file_is_the_start() {
        const Folder folder;
        for (const int container :
             std::initializer_list<int>{SF_FORMAT_WAV, int{SF_FORMAT_WAV} | int{SF_ENDIAN_BIG},
                                        SF_FORMAT_WAVEX, SF_FORMAT_RF64, SF_FORMAT_FLAC}) {
            write_audio(folder.file("run"), wave(20), container | SF_FORMAT_PCM_16, 48000, 2,
                        "2020-09-01 10:20");
            QCOMPARE(opened(folder.file("run")).start, std::string("2020-09-01 10:20"));
        }
        write_audio(folder.file("run.wav"), wave(20), SF_FORMAT_WAV | SF_FORMAT_PCM_16);
        QCOMPARE(opened(folder.file("run.wav")).start, std::string());
    }

    void the_date_of_a_broadcast_wave_is_the_start() {
        const Folder folder;
        SF_INFO info{};
        info.samplerate = 48000;
        info.channels = 2;
        info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
        SNDFILE* file = sf_open(folder.file("run.wav").c_str(), SFM_WRITE, &info);
        SF_BROADCAST_INFO broadcast{};
        std::memcpy(broadcast.origination_date, "2021-02-03", 10);  // the fields have no final zero
        std::memcpy(broadcast.origination_time, "11:22:33", 8);
        QCOMPARE(sf_command(file, SFC_SET_BROADCAST_INFO, &broadcast, sizeof broadcast), SF_TRUE);
        const std::vector<double> silence(20, 0.0);
        sf_writef_double(file, silence.data(), 10);
        sf_close(file);
        QCOMPARE(opened(folder.file("run.wav")).start, std::string("2021-02-03 11:22:33"));
    }

    void two_threads_read_what_one_reads_data() {
        QTest::addColumn<int>("format");
        QTest::newRow("WAV") << (SF_FORMAT_WAV | SF_FORMAT_PCM_24);
        QTest::newRow("FLAC") << (SF_FORMAT_FLAC | SF_FORMAT_PCM_24);
    }

    void two_threads_read_what_one_reads() {
        QFETCH(int, format);
        const Folder folder;
        write_audio(folder.file("run"), wave(60000), format);
        const Recording recording = opened(folder.file("run"));
        const Samples alone = read_all(recording);
        // One goes forward through the file and the other backward, in blocks of their own size.
        const auto differences = [&](std::int64_t block, bool backward) {
            std::int64_t count = 0;
            for (std::int64_t k = 0; k < recording.frames() / block; ++k) {
                const std::int64_t first =
                    (backward ? recording.frames() / block - 1 - k : k) * block;
                std::vector<double> c(static_cast<std::size_t>(block)), d(c);
                const bool same = recording.source->read(first, c, d) &&
                                  std::equal(c.begin(), c.end(), alone.c.begin() + first) &&
                                  std::equal(d.begin(), d.end(), alone.d.begin() + first);
                count += same ? 0 : 1;
            }
            return count;
        };
        std::int64_t forward = -1;
        std::int64_t backward = -1;
        std::thread other([&] { forward = differences(600, false); });
        backward = differences(477, true);
        other.join();
        QCOMPARE(forward, 0);
        QCOMPARE(backward, 0);
    }
};

VYBEG_TEST(TestAudioReader, threads)

}  // namespace test_audio_reader

#include "test_audio_reader.moc"
