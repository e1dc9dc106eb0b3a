#include "core/recording/audio/audio_reader.h"
#include "tests/closeness.h"
#include "tests/core/recording/audio/audio_files.h"
#include "tests/test_registry.h"

namespace test_damaged_audio {

using namespace vybeg;
using namespace vybeg::test;

class TestDamagedAudio : public QObject {
    Q_OBJECT

private slots:
    void a_file_cut_short_opens_with_what_is_there_data() {
        QTest::addColumn<int>("format");
        QTest::newRow("WAV") << (SF_FORMAT_WAV | SF_FORMAT_PCM_24);
        QTest::newRow("WAV, big endian") << (SF_FORMAT_WAV | SF_ENDIAN_BIG | SF_FORMAT_PCM_24);
        QTest::newRow("WAVEX") << (SF_FORMAT_WAVEX | SF_FORMAT_PCM_24);
        QTest::newRow("RF64") << (SF_FORMAT_RF64 | SF_FORMAT_PCM_24);
        QTest::newRow("W64") << (SF_FORMAT_W64 | SF_FORMAT_PCM_24);
        QTest::newRow("AIFF") << (SF_FORMAT_AIFF | SF_FORMAT_PCM_24);
        QTest::newRow("CAF") << (SF_FORMAT_CAF | SF_FORMAT_PCM_24);
        QTest::newRow("FLAC") << (SF_FORMAT_FLAC | SF_FORMAT_PCM_24);
    }

    void a_file_cut_short_opens_with_what_is_there() {
        QFETCH(int, format);
        const Folder folder;
        write_audio(folder.file("whole"), wave(30000), format);
        const std::string bytes = bytes_of(folder.file("whole"));
        const auto cut =
            folder.write("cut", std::string_view(bytes).substr(0, bytes.size() * 2 / 3));
        const Recording recording = opened(cut);
        const Diagnostic* early = find(recording, DiagnosticKind::file_ends_early);
        QVERIFY(early);
        QCOMPARE(early->args,
                 (std::vector<MessageArg>{"30000", std::to_string(recording.frames())}));
        QCOMPARE(early->first_frame, recording.frames());
        QCOMPARE(early->count, 30000 - recording.frames());
        // Two thirds are there, to the container's header or the block of FLAC's encoder.
        const std::int64_t slack =
            (format & SF_FORMAT_TYPEMASK) == SF_FORMAT_FLAC ? 4096 + 600 : 700;
        VYBEG_CLOSE(recording.frames(), 20000, slack);

        const Samples read = read_all(recording);
        Samples whole = read_all(opened(folder.file("whole")));
        whole.c.resize(read.c.size());
        whole.d.resize(read.d.size());
        QCOMPARE(read, whole);
    }

    void a_whole_file_with_chunks_behind_its_samples_ends_where_it_should() {
        const Folder folder;
        for (const int container :
             {SF_FORMAT_WAV, SF_FORMAT_RF64, SF_FORMAT_W64, SF_FORMAT_AIFF, SF_FORMAT_CAF}) {
            write_audio(folder.file("run"), wave(1001), container | SF_FORMAT_PCM_16, 1000, 2,
                        "2020");
            const Recording recording = opened(folder.file("run"));
            QCOMPARE(recording.frames(), 1001);
            QVERIFY(recording.diagnostics.empty());
            const auto file = FileBytes::open(folder.file("run"));
            QVERIFY(file);
            const auto extent = audio_extent(**file);
            QVERIFY(extent);
            QCOMPARE(extent->promised_frames.value_or(-1), 1001);
            QVERIFY(extent->patches.empty());
        }
    }

    void a_stream_whose_length_was_never_filled_in_is_no_damage() {
        const Folder folder;
        write_audio(folder.file("run"), wave(1000), SF_FORMAT_WAV | SF_FORMAT_PCM_16);
        std::string bytes = bytes_of(folder.file("run"));
        for (const std::size_t size_at : {std::size_t{4}, bytes.find("data") + 4}) {
            bytes.replace(size_at, 4, 4, '\xFF');
        }
        const Recording recording = opened(folder.write("streamed", bytes));
        QCOMPARE(recording.frames(), 1000);
        QVERIFY(recording.diagnostics.empty());
    }

    void a_recorder_that_died_leaves_its_samples_data() {
        QTest::addColumn<int>("format");
        QTest::addColumn<int>("over");  // bytes of a last frame that is not whole
        QTest::addColumn<QByteArray>("riff_size");
        const QByteArray zero(4, '\0'), header_alone("\x24\0\0\0", 4);
        QTest::newRow("16 bits") << (SF_FORMAT_WAV | SF_FORMAT_PCM_16) << 0 << zero;
        QTest::newRow("16 bits, half a frame") << (SF_FORMAT_WAV | SF_FORMAT_PCM_16) << 2 << zero;
        QTest::newRow("24 bits") << (SF_FORMAT_WAV | SF_FORMAT_PCM_24) << 5 << header_alone;
        QTest::newRow("32 bits") << (SF_FORMAT_WAVEX | SF_FORMAT_PCM_32) << 0 << header_alone;
        QTest::newRow("floats") << (SF_FORMAT_WAV | SF_FORMAT_FLOAT) << 7 << zero;
        QTest::newRow("doubles") << (SF_FORMAT_WAV | SF_FORMAT_DOUBLE) << 0 << zero;
        QTest::newRow("big endian")
            << (SF_FORMAT_WAV | SF_ENDIAN_BIG | SF_FORMAT_PCM_16) << 0 << zero;
    }

    void a_recorder_that_died_leaves_its_samples() {
        QFETCH(int, format);
        QFETCH(int, over);
        QFETCH(QByteArray, riff_size);
        const Folder folder;
        write_audio(folder.file("run"), wave(1000), format);
        const Samples whole = read_all(opened(folder.file("run")));
        std::string bytes = bytes_of(folder.file("run"));
        const std::size_t data = bytes.find("data");
        const auto stride = static_cast<std::size_t>(
            opened(folder.file("run")).frames() > 0 ? (bytes.size() - data - 8) / 1000 : 0);
        bytes.resize(data + 8 + 1000 * stride);  // without what was written when it was closed
        bytes.replace(4, 4, riff_size.toStdString());
        bytes.replace(data + 4, 4, 4, '\0');
        bytes.resize(bytes.size() - stride + static_cast<std::size_t>(over));
        const Recording recording = opened(folder.write("died", bytes));
        QCOMPARE(recording.frames(), 999);
        QCOMPARE(recording.diagnostics.size(), 1u);
        QVERIFY(recording.diagnostics[0].kind == DiagnosticKind::file_not_closed);
        QCOMPARE(recording.diagnostics[0].args, std::vector<MessageArg>{"999"});
        const Samples read = read_all(recording);
        QVERIFY(same_bits(read.c, std::span(whole.c).first(999)));
        QVERIFY(same_bits(read.d, std::span(whole.d).first(999)));
    }

    void a_chunk_of_the_least_size_that_64_bits_hold_is_damage() {
        const Folder folder;
        write_audio(folder.file("run"), wave(10), SF_FORMAT_W64 | SF_FORMAT_PCM_16);
        std::string bytes = bytes_of(folder.file("run"));
        bytes.replace(bytes.find("fmt ") + 16, 8, std::string(7, '\0') + '\x80');
        QVERIFY(!open(folder.write("least", bytes)));
    }

    void an_encoding_that_no_decoder_knows_is_no_damage() {
        const Folder folder;
        write_audio(folder.file("run"), wave(10), SF_FORMAT_WAV | SF_FORMAT_PCM_16);
        std::string bytes = bytes_of(folder.file("run"));
        bytes[bytes.find("fmt ") + 8] = 0x55;  // MPEG layer 3
        const auto refused = open(folder.write("packed", bytes));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::format_unsupported);
        QVERIFY(english(refused.error()).find("samples in the encoding 85") != std::string::npos);
    }

    void an_empty_data_chunk_before_others_is_empty() {
        const Folder folder;
        write_audio(folder.file("run"), wave(10), SF_FORMAT_WAV | SF_FORMAT_PCM_16);
        std::string bytes = bytes_of(folder.file("run"));
        const std::size_t data = bytes.find("data");
        bytes.resize(data + 8);
        bytes.replace(data + 4, 4, 4, '\0');
        const auto refused = open(folder.write("none", bytes));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::too_few_frames);
        bytes += std::string("note\6\0\0\0abcdef", 14) + std::string("LIST\4\0\0\0INFO", 12);
        const auto followed = open(folder.write("followed", bytes));
        QVERIFY(!followed);
        QCOMPARE(followed.error().code, ErrorCode::too_few_frames);
    }

    void a_damaged_flac_block_is_an_error_and_never_samples_data() {
        QTest::addColumn<double>("place");  // of the file's length
        QTest::addColumn<int>("length");    // bytes
        QTest::addColumn<int>("pattern");   // the bits that turn over
        for (const double place : {0.1, 0.31, 0.5, 0.73, 0.9}) {
            QTest::addRow("40 bytes at %g", place) << place << 40 << 0x55;
            QTest::addRow("one bit at %g", place) << place << 1 << 0x10;
        }
    }

    void a_damaged_flac_block_is_an_error_and_never_samples() {
        QFETCH(double, place);
        QFETCH(int, length);
        QFETCH(int, pattern);
        const Folder folder;
        write_audio(folder.file("run"), wave(60000), SF_FORMAT_FLAC | SF_FORMAT_PCM_16);
        const Samples whole = read_all(opened(folder.file("run")));
        std::string bytes = bytes_of(folder.file("run"));
        const auto first_wrong =
            static_cast<std::size_t>(place * static_cast<double>(bytes.size()));
        for (std::size_t i = 0; i < static_cast<std::size_t>(length); ++i) {
            bytes[first_wrong + i] = static_cast<char>(bytes[first_wrong + i] ^ pattern);
        }
        const Recording recording = opened(folder.write("damaged", bytes));
        std::vector<double> c(500), d(500);
        std::int64_t refused = 0;
        std::int64_t wrong = 0;
        // Forward, then backward: what comes after an error must be right too, or an error again.
        for (const int direction : {1, -1}) {
            for (std::int64_t k = 0; k < 120; ++k) {
                const std::int64_t first = 500 * (direction > 0 ? k : 119 - k);
                const Status status = recording.source->read(first, c, d);
                if (!status) {
                    QCOMPARE(status.error().code, ErrorCode::format_damaged);
                    ++refused;
                } else if (!std::equal(c.begin(), c.end(), whole.c.begin() + first) ||
                           !std::equal(d.begin(), d.end(), whole.d.begin() + first)) {
                    ++wrong;
                }
            }
        }
        QCOMPARE(wrong, 0);
        VYBEG_AT_LEAST(refused, 2);
        VYBEG_AT_MOST(refused, 2 * 30);  // a block of 4096 or two, and not the rest of the file
    }

    void a_flac_that_is_cut_anywhere_gives_its_true_first_samples_or_an_error() {
        const Folder folder;
        write_audio(folder.file("run"), wave(12000), SF_FORMAT_FLAC | SF_FORMAT_PCM_16);
        const Samples whole = read_all(opened(folder.file("run")));
        const std::string bytes = bytes_of(folder.file("run"));
        int opened_files = 0;
        for (std::size_t length = 5; length < bytes.size(); length += bytes.size() / 37) {
            const auto recording =
                open(folder.write("cut", std::string_view(bytes).substr(0, length)));
            if (!recording) {
                QVERIFY(recording.error().code == ErrorCode::format_damaged ||
                        recording.error().code == ErrorCode::too_few_frames);
                continue;
            }
            ++opened_files;
            const Samples read = read_all(*recording);
            QVERIFY(find(*recording, DiagnosticKind::file_ends_early));
            VYBEG_LESS(read.c.size(), whole.c.size());
            QVERIFY(std::equal(read.c.begin(), read.c.end(), whole.c.begin()));
            QVERIFY(std::equal(read.d.begin(), read.d.end(), whole.d.begin()));
        }
        VYBEG_MORE(opened_files, 10);
    }

    void a_header_alone_is_no_recording_data() {
        QTest::addColumn<QByteArray>("head");
        QTest::newRow("RIFF") << QByteArray("RIFF\x24\0\0\0WAVEfmt ", 16);
        QTest::newRow("RF64") << QByteArray("RF64\xFF\xFF\xFF\xFFWAVEds64", 16);
        QTest::newRow("AIFF") << QByteArray(
            "FORM\0\0\0\x20"
            "AIFFCOMM",
            16);
        QTest::newRow("CAF") << QByteArray("caff\0\1\0\0desc\0\0\0\0", 16);
        QTest::newRow("FLAC") << QByteArray("fLaC\0\0\0\x22", 8);
    }

    void a_header_alone_is_no_recording() {
        QFETCH(QByteArray, head);
        const Folder folder;
        const auto recording = open(folder.write("head", head.toStdString()));
        QVERIFY(!recording);
        QCOMPARE(recording.error().code, ErrorCode::format_damaged);
    }

    void a_list_that_makes_the_decoder_go_round_for_ever_is_not_shown_to_it() {
        const Folder folder;
        write_audio(folder.file("whole"), wave(100), SF_FORMAT_WAV | SF_FORMAT_PCM_16);
        std::string bytes = bytes_of(folder.file("whole"));
        std::string list("LIST\x60\0\0\0", 8);
        list += std::string(0x60, '\xFF');
        bytes.insert(bytes.find("data"), list);
        const Recording recording = opened(folder.write("damaged", bytes));
        QCOMPARE(recording.frames(), 100);
        QCOMPARE(read_all(recording).c, read_all(opened(folder.file("whole"))).c);
    }

    void random_damage_to_headers_never_hangs_or_crashes_data() {
        a_file_cut_short_opens_with_what_is_there_data();
    }

    void random_damage_to_headers_never_hangs_or_crashes() {
        QFETCH(int, format);
        const Folder folder;
        write_audio(folder.file("whole"), wave(600), format);
        const std::string bytes = bytes_of(folder.file("whole"));
        std::uint32_t random = 1;
        int refused = 0;
        for (int trial = 0; trial < 100; ++trial) {
            std::string damaged = bytes;
            for (int i = 0; i < 3; ++i) {
                random = random * 1664525u + 1013904223u;
                damaged[(random >> 8) % 120] = static_cast<char>(random >> 24);
            }
            const auto recording = open(folder.write(std::to_string(trial), damaged));
            if (!recording) {
                VYBEG_EQUAL(exit_status(recording.error().code), 3);
                ++refused;
                continue;
            }
            // What a wrong header still lets through must be readable to its end, or say that it is
            // not.
            VYBEG_AT_LEAST(recording->frames(), 5);
            VYBEG_AT_MOST(recording->frames(), 30000);
            std::vector<double> c(static_cast<std::size_t>(recording->frames())), d(c);
            const Status status = recording->source->read(0, c, d);
            QVERIFY(status || status.error().code == ErrorCode::format_damaged);
        }
        VYBEG_MORE(refused, 0);
    }
};

VYBEG_TEST(TestDamagedAudio)

}  // namespace test_damaged_audio

#include "test_damaged_audio.moc"
