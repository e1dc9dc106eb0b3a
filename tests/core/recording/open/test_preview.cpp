// The beginning of a file as the import dialog shows it: what open_recording() reads, told before
// the file is read.
#include "core/recording/bytes/number_type.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/open/preview.h"
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/needed.h"
#include "tests/test_registry.h"

#include <ctime>
#include <unistd.h>

namespace test_preview {

using namespace vybeg;
using namespace vybeg::test;

namespace {

RecordingPreview shown(const std::filesystem::path& path, const OpenOptions& options = {}) {
    return needed(preview_recording(path, options, {}));
}

std::string rows(int count, char separator, bool timed) {
    std::string text;
    const Samples samples = wave(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        text += timed ? QByteArray::number(i * 3e-5, 'f', 6).toStdString() + separator : "";
        text += QByteArray::number(samples.c[k], 'g', 9).toStdString() + separator;
        text += QByteArray::number(samples.d[k], 'g', 9).toStdString() + "\n";
    }
    return text;
}

}  // namespace

class TestPreview : public QObject {
    Q_OBJECT

    Folder folder_;

    // The preview's samples are the first of those that are read.
    static void as_opened(const std::filesystem::path& path, const OpenOptions& options) {
        const RecordingPreview preview = shown(path, options);
        QVERIFY2(!preview.problem, preview.problem ? english(*preview.problem).c_str() : "");
        const Recording recording = opened(path, options);
        QCOMPARE(preview.format, recording.format);
        QCOMPARE(preview.channels, recording.channels);
        const auto frames = std::min<std::int64_t>(recording.frames(), preview_frames);
        QCOMPARE(std::ssize(preview.c), frames);
        const Samples first = test::read(*recording.source, 0, frames);
        QVERIFY(same_bits(preview.c, first.c));
        QVERIFY(same_bits(preview.d, first.d));
        VYBEG_CLOSE_RATIO(preview.rate_hz.value_or(0), recording.rate_hz, 1e-3);
        QVERIFY(!preview.lines.empty());
        VYBEG_AT_MOST(preview.lines.size(), preview_lines);
    }

private slots:
    void a_preview_is_what_will_be_read_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<OpenOptions>("options");
        const auto add = [](const char* name, const std::string& bytes,
                            const OpenOptions& options = {}) {
            QTest::newRow(name) << QString(name) << QByteArray::fromStdString(bytes) << options;
        };
        const OpenOptions rate{.rate_hz = 33333};
        add("short.csv", "C,D\n" + rows(50, ',', false), rate);
        add("long.csv", "t,C,D\n" + rows(30000, ',', true));
        add("missing.csv", "1;2\n;3\n4;nan\n5;6\n7;8\n9;10", rate);
        OpenOptions choice = rate;
        choice.text = TextChoice{.delimiter = ';', .decimal_comma = true, .lines_to_skip = 2};
        choice.scale = 0.1;
        choice.unit = "V";
        add("choice.csv", "1;2\nC;D\n1,5;2\n3;4\n5;6\n7,25;8\n9;10\n", choice);
        const OpenOptions swapped{.channel_c = 2, .channel_d = 1};
        add("swapped.csv", "t,C,D\n" + rows(3000, ',', true), swapped);
        std::string bytes = "head";
        for (int i = 0; i < 30000; ++i) {
            bytes += store(static_cast<std::int16_t>(1000 * std::cos(0.9 * i)), true);
        }
        OpenOptions raw = rate;
        raw.raw =
            RawLayout{.type = RawType::i16, .big_endian = true, .channels = 3, .skip_bytes = 4};
        raw.scale = 0.5;
        raw.channel_c = 3;
        add("raw.bin", bytes, raw);
    }
    void a_preview_is_what_will_be_read() {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(OpenOptions, options);
        as_opened(folder_.write(name.toStdString(), bytes.toStdString()), options);
    }

    void lines_above_the_table_are_lines_and_rows_are_cells() {
        const RecordingPreview preview =
            shown(folder_.write("t.csv",
                                "a report\n\nt [s];S_C [V];S_D [V]\n0;1,5;2\n1;3;4,5\n"
                                "2;0;1\n3;0;1\n4;0;1\n"));
        QVERIFY(!preview.problem);
        QCOMPARE(preview.lines.size(), 8u);
        QVERIFY(!preview.lines[2].is_row);
        QCOMPARE(preview.lines[2].number, 3);
        QCOMPARE(preview.lines[2].cells, (std::vector<std::string>{"t [s];S_C [V];S_D [V]"}));
        QVERIFY(preview.lines[4].is_row);
        QCOMPARE(preview.lines[4].cells, (std::vector<std::string>{"1", "3", "4,5"}));
        QCOMPARE(preview.time_column, 0);
        QCOMPARE(preview.c_column, 1);
        QCOMPARE(preview.d_column, 2);
        QCOMPARE(preview.columns[1], (Channel{"S_C", "V"}));
        QCOMPARE(preview.time_s, (std::vector<double>{0, 1, 2, 3, 4}));
        QVERIFY(preview.guessed && preview.used && *preview.guessed == *preview.used);
        QCOMPARE(preview.guessed->delimiter, ';');
    }

    void a_format_that_gives_no_table_says_why_and_still_shows_the_lines() {
        const auto path = folder_.write("d.csv", "C;D\n1,5;2,5\n3,5;4,5\n5;6\n7;8\n9;1\n");
        const OpenOptions options{.rate_hz = 100, .text = TextChoice{.delimiter = '\t'}};
        const RecordingPreview preview = shown(path, options);
        QVERIFY(preview.problem);
        QCOMPARE(preview.problem->code, ErrorCode::text_no_table);
        QCOMPARE(*preview.problem, open(path, options).error());
        QCOMPARE(preview.lines.size(), 6u);
        QCOMPARE(preview.lines[1].cells, (std::vector<std::string>{"1,5;2,5"}));
        QVERIFY(preview.c.empty());
        QVERIFY(preview.guessed);
        QCOMPARE(preview.guessed->delimiter, ';');
    }

    void what_is_wrong_with_the_first_rows_is_told_as_reading_tells_it_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<OpenOptions>("options");
        OpenOptions none;
        const OpenOptions rate{.rate_hz = 10};
        QTest::newRow("no rate") << QByteArray("1 2\n3 4\n5 6\n7 8\n9 1\n") << none;
        QTest::newRow("no number") << QByteArray("1 2\n3 4\n5 x\n7 8\n9 1\n1 1\n") << rate;
        QTest::newRow("time") << QByteArray("t,C,D\n0.1,1,2\n0.2,1,2\n0.15,3,4\n0.3,1,2\n0.4,1,1\n")
                              << none;
        QTest::newRow("one channel")
            << QByteArray("t,C\n0.1,1\n0.2,2\n0.3,3\n0.4,1\n0.5,1\n") << none;
        QTest::newRow("short") << QByteArray("1 2\n3 4\n") << rate;
        OpenOptions third = rate;
        third.channel_d = 3;
        QTest::newRow("channel") << QByteArray("1 2\n3 4\n5 6\n7 8\n9 1\n") << third;
        OpenOptions raw{.raw = RawLayout{.channels = 2}};
        QTest::newRow("raw without a rate") << QByteArray("1234567890abcdef1234567890") << raw;
        raw.rate_hz = 10;
        raw.raw->skip_bytes = 1000;
        QTest::newRow("raw behind the end") << QByteArray("1234567890abcdef1234567890") << raw;
        QTest::newRow("unknown") << QByteArray("\0\1\2\3\4\5", 6) << rate;
    }
    void what_is_wrong_with_the_first_rows_is_told_as_reading_tells_it() {
        QFETCH(QByteArray, bytes);
        QFETCH(OpenOptions, options);
        const auto path = folder_.write("wrong", bytes.toStdString());
        const auto wrong = open(path, options);
        QVERIFY(!wrong);
        const RecordingPreview preview = shown(path, options);
        QVERIFY(preview.problem);
        QCOMPARE(english(*preview.problem), english(wrong.error()));
    }

    void without_a_rate_the_samples_are_shown_all_the_same() {
        const RecordingPreview text = shown(folder_.write("n.csv", "1 2\n3 4\n5 6\n7 8\n9 1\n"));
        QCOMPARE(text.c, (std::vector<double>{1, 3, 5, 7, 9}));
        QVERIFY(!text.rate_hz);
        const OpenOptions raw{.raw = RawLayout{.type = RawType::i16}};
        const RecordingPreview binary = shown(folder_.write("n.bin", std::string(40, '\1')), raw);
        QCOMPARE(binary.c.size(), 10u);
        QVERIFY(!binary.rate_hz);
    }

    void raw_cells_are_those_of_every_channel() {
        std::string bytes = "??";
        for (int i = 0; i < 60; ++i) {
            bytes += store(static_cast<std::int16_t>(i), false);
        }
        const OpenOptions options{.rate_hz = 100,
                                  .channel_c = 5,
                                  .raw = RawLayout{.channels = 6, .skip_bytes = 2},
                                  .scale = 0.5};
        const RecordingPreview preview = shown(folder_.write("six.bin", bytes), options);
        QCOMPARE(preview.lines.size(), 10u);
        QCOMPARE(preview.lines[1].cells,
                 (std::vector<std::string>{"3", "3.5", "4", "4.5", "5", "5.5"}));
        QCOMPARE(preview.c_column, 4);
        QCOMPARE(preview.d_column, 1);
        QVERIFY(!preview.file_format);
    }

    void a_file_of_no_format_is_told() {
        const RecordingPreview preview = shown(folder_.write("f32.bin", std::string(4000, '\1')));
        QVERIFY(!preview.file_format);
        QCOMPARE(preview.problem->code, ErrorCode::format_unknown);
    }

    void a_file_that_is_not_there_is_an_error() {
        const auto missing = preview_recording(folder_.file("none.csv"), {}, {});
        QVERIFY(!missing);
        QCOMPARE(missing.error().code, ErrorCode::file_missing);
    }

    // 3 GB, most of them a hole: read whole it would take seconds at the least.
    void a_huge_file_takes_no_longer_than_a_small_one() {
        const auto text = folder_.write("huge.csv", "t,C,D\n" + rows(60000, ',', true));
        const auto raw = folder_.write("huge.bin", std::string(100000, '\1'));
        const OpenOptions layout{.rate_hz = 1000, .raw = RawLayout{}};
        const auto processor_s = [&] {  // a busy machine fails no test
            const std::clock_t before = std::clock();
            const auto first = shown(text).c.size() + shown(raw, layout).c.size();
            return first == 2 * preview_frames
                       ? static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC
                       : -1.0;
        };
        const double small = processor_s();
        for (const auto& path : {text, raw}) {
            QCOMPARE(truncate(path.c_str(), off_t{3} << 30), 0);
        }
        const double huge = processor_s();
        VYBEG_AT_LEAST(small, 0);
        VYBEG_AT_LEAST(huge, 0);
        VYBEG_LESS(huge, 2 * small + 0.3);
    }
};

VYBEG_TEST(TestPreview, threads)

}  // namespace test_preview

#include "test_preview.moc"
