#include "tests/closeness.h"
#include "tests/core/recording/damaged_files.h"
#include "tests/core/recording/recording_files.h"
#include "tests/core/recording/text/uff_file.h"
#include "tests/test_registry.h"

#include <functional>

namespace test_uff_reader {

using namespace vybeg;
using namespace vybeg::test;
using namespace std::string_view_literals;

namespace {

std::string two_channels(const Samples& samples, UffText text = {}) {
    const std::string c = uff58(samples.c, text);
    text.name = "Other";
    return c + uff58(samples.d, text);
}

}  // namespace

class TestUffReader : public QObject {
    Q_OBJECT

private slots:
    void single_and_double_precision_come_back_to_their_digits_data() {
        QTest::addColumn<bool>("doubles");
        QTest::addColumn<QString>("line_end");
        QTest::newRow("6E13.5") << false << "\n";
        QTest::newRow("6E13.5, CRLF") << false << "\r\n";
        QTest::newRow("4E20.12") << true << "\n";
    }

    void single_and_double_precision_come_back_to_their_digits() {
        QFETCH(bool, doubles);
        QFETCH(QString, line_end);
        const Samples samples = wave(20001);  // the last line is not full
        const UffText text{.doubles = doubles, .line_end = line_end.toStdString()};
        const Folder folder;
        const Recording recording = opened(folder.write("run.uff", two_channels(samples, text)));
        QCOMPARE(english(recording.format), std::string("UFF, dataset 58, 2 channels"));
        QVERIFY(recording.diagnostics.empty());
        const Samples read = read_all(recording);
        // Half a unit of the last decimal, of values below 1.
        const double rounding = doubles ? 0.5e-12 : 0.5e-5;
        VYBEG_WITHIN(worst_difference(read.c, samples.c), 0, rounding);
        VYBEG_WITHIN(worst_difference(read.d, samples.d), 0, rounding);
    }

    void binary_numbers_are_read_in_place_data() {
        QTest::addColumn<bool>("big_endian");
        QTest::addColumn<bool>("doubles");
        QTest::addColumn<QString>("line_end");
        QTest::addColumn<QString>("between");
        for (const bool big_endian : {false, true}) {
            for (const bool doubles : {false, true}) {
                for (const char* line_end : {"\n", "\r\n"}) {
                    for (const bool apart : {false, true}) {
                        QTest::addRow("%s endian, %d bits, %s, separator %s",
                                      big_endian ? "big" : "little", doubles ? 64 : 32,
                                      *line_end == '\n' ? "LF" : "CRLF",
                                      apart ? "on a line of its own" : "at once")
                            << big_endian << doubles << QString(line_end)
                            << QString(apart ? line_end : "");
                    }
                }
            }
        }
    }

    void binary_numbers_are_read_in_place() {
        QFETCH(bool, big_endian);
        QFETCH(bool, doubles);
        QFETCH(QString, line_end);
        QFETCH(QString, between);
        // Among them every byte that ends a line or begins a separator.
        Samples samples = wave(20001);
        for (std::size_t i = 0; i < 100; ++i) {
            samples.c[i] = 0x0A0D0A0D / 1e9 + 1e-3 * static_cast<double>(i);
        }
        UffText text{.line_end = line_end.toStdString()};
        UffBytes bytes{big_endian, doubles, 2, -1, between.toStdString()};
        const Folder folder;
        std::string content = uff58b(samples.c, text, bytes);
        text.name = "Other";
        content += "    -1\n   151\nmodel\n    -1\n" + uff58b(samples.d, text, bytes);
        const Recording recording = opened(folder.write("run.uff", content));
        QCOMPARE(english(recording.format), std::string("UFF, dataset 58b, 2 channels"));
        QCOMPARE(recording.channels[1].name, std::string("Other"));
        QVERIFY(recording.diagnostics.empty());
        const Samples read = read_all(recording);
        const auto kept = [&](std::vector<double> values) {
            for (double& value : values) {
                value = doubles ? value : static_cast<double>(static_cast<float>(value));
            }
            return values;
        };
        QCOMPARE(worst_difference(read.c, kept(samples.c)), 0.0);
        QCOMPARE(worst_difference(read.d, kept(samples.d)), 0.0);
        QVERIFY(same_however_cut(*recording.source, 5000));
    }

    void binary_and_text_may_stand_in_one_file() {
        const Samples samples{{1, 2, 3, 4, 5}, {6, 7, 8, 9, 10}};
        const UffText spectrum{.function = 4, .axis = 18};
        const Folder folder;
        const Recording recording =
            opened(folder.write("run.uff", uff58b(samples.d, spectrum) + uff58(samples.c) +
                                               uff58b(samples.d) + uff58(samples.d)));
        QCOMPARE(recording.channels.size(), 3u);
        QCOMPARE(read_all(recording), samples);
    }

    void a_binary_file_cut_short_opens_with_what_is_there() {
        const Samples samples = wave(600);
        std::string bytes = uff58b(samples.c) + uff58b(samples.d);
        bytes.resize(bytes.size() - 7 - 66 * 8 - 3);
        const Folder folder;
        const Recording recording = opened(folder.write("cut.uff", bytes));
        QCOMPARE(recording.frames(), 600 - 67);
        const Diagnostic* early = find(recording, DiagnosticKind::file_ends_early);
        QVERIFY(early);
        QCOMPARE(early->args, (std::vector<MessageArg>{"600", "533"}));
        QCOMPARE(read_all(recording).d[532], samples.d[532]);
    }

    void a_binary_header_that_lies_is_damage_data() {
        QTest::addColumn<QByteArray>("bytes");
        const Samples samples = wave(10);
        const auto add = [&](const char* name, const UffBytes& b, const std::string& count = "") {
            const UffText text{.count = count};
            QTest::newRow(name) << QByteArray::fromStdString(uff58b(samples.c, text, b) +
                                                             uff58b(samples.d, text, b));
        };
        add("bytes too few", {false, true, 2, 72, ""});
        add("bytes too many", {false, true, 2, 88, ""});
        add("more bytes than any file has", {false, true, 2, 9000000000000000000, ""});
        add("values too many", {}, "9");
        add("2^61 values", {}, "2305843009213693952");
        add("text after the numbers", {false, true, 2, -1, "1.0 2.0\n"});
        std::string order = uff58b(samples.c) + uff58b(samples.d);
        order.replace(order.find("58b     1"), 9, "58b     3");
        QTest::newRow("byte order") << QByteArray::fromStdString(order);
        order.replace(order.find("58b     3"), 9, "58b     x");
        QTest::newRow("no number") << QByteArray::fromStdString(order);
    }

    void a_binary_header_that_lies_is_damage() {
        QFETCH(QByteArray, bytes);
        const Folder folder;
        const auto recording = open(folder.write("run.uff", bytes.toStdString()));
        QVERIFY(!recording);
        QVERIFY2(recording.error().code == ErrorCode::format_damaged,
                 english(recording.error()).c_str());
    }

    void rate_names_units_and_start_come_from_the_header() {
        UffText text{.name = "Электрод C", .time_unit = "ms", .step_s = 0.03};
        const Folder folder;
        std::string bytes = uff58(wave(10).c, text);
        text.name = "NONE";
        text.unit = "NONE";
        bytes += uff58(wave(10).d, text);
        const OpenOptions options{.rate_hz = 5};
        const Recording recording = opened(folder.write("run.uff", bytes), options);
        VYBEG_CLOSE(recording.rate_hz, 1 / 0.03e-3, 1e-9 * recording.rate_hz);
        QCOMPARE(recording.rate_from, RateOrigin::file);
        QCOMPARE(recording.start, std::string("01-MAR-20 12:34:56"));
        QCOMPARE(recording.channels[0], (Channel{"Электрод C", "V"}));
        QCOMPARE(recording.channels[1], (Channel{"12-Z", ""}));  // node and direction

        text.step_s = 0;
        const auto path =
            folder.write("no-step.uff", uff58(wave(10).c, text) + uff58(wave(10).d, text));
        QCOMPARE(opened(path, options).rate_from, RateOrigin::option);
        QCOMPARE(open(path).error().code, ErrorCode::rate_unknown);
    }

    void six_digits_of_the_step_leave_the_rate_open() {
        const Folder folder;
        for (const double rate_hz : {33333.0, 44100.0, 51200.0, 11025.0, 20480.0}) {
            const UffText text{.step_s = 1 / rate_hz};
            const Recording recording =
                opened(folder.write("run.uff", uff58(wave(10).c, text) + uff58(wave(10).d, text)));

            const double sd = recording.rate_relative_sd;
            // Half of the sixth digit is sqrt(3) standard deviations.
            VYBEG_CLOSE_RATIO(recording.rate_hz, rate_hz, 1.74 * sd + 1e-12);
            VYBEG_MORE(sd, 2e-7);
            VYBEG_LESS(sd, 3e-6);
        }
    }

    void values_may_touch_and_exponents_may_be_of_fortran() {
        Samples samples{{-1, -2, -3, -4, -5, -6, -7}, {1.5, -2.5, 3.5, -4.5, 5.5, -6.5, 7.5}};
        const UffText text{.blanks = false};
        const Folder folder;
        QCOMPARE(read_all(opened(folder.write("touching.uff",
                                              uff58(samples.c, text) + uff58(samples.d))))
                     .c,
                 samples.c);
        std::string bytes = two_channels(samples);
        for (std::size_t at = bytes.find("E+00"); at != bytes.npos; at = bytes.find("E+00", at)) {
            bytes[at] = 'D';
        }
        QCOMPARE(read_all(opened(folder.write("fortran.uff", bytes))).d, samples.d);
        bytes.replace(bytes.rfind("7.50000D+00"), 11, "        NaN");
        QVERIFY(std::isnan(read_all(opened(folder.write("missing.uff", bytes))).d[6]));
    }

    void other_datasets_are_passed_over() {
        const Samples samples{{1, 2, 3, 4, 5}, {6, 7, 8, 9, 10}};
        const UffText spectrum{.function = 4, .data_type = 5, .axis = 18};
        const std::string bytes =
            "    -1\n   151\nMODEL\n58\n    -1\n" + uff58(samples.c) + uff58(samples.d, spectrum) +
            "    -1\n    15\n 1 0 0 8 0.0 0.0 0.0\n    -1\n" + uff58(samples.d);
        const Folder folder;
        const Recording recording = opened(folder.write("run.uff", bytes));
        QCOMPARE(recording.channels.size(), 2u);
        QCOMPARE(read_all(recording), samples);
    }

    void channels_are_chosen_among_those_like_the_first() {
        const std::vector<double> one{1, 2, 3, 4, 5}, two{6, 7, 8, 9, 10}, three{0, 1, 0, 1, 0};
        const UffText slow{.step_s = 1};
        const Folder folder;
        const auto path =
            folder.write("run.uff", uff58(one) + uff58(two, slow) + uff58(std::vector<double>(7)) +
                                        uff58(two) + uff58(three));
        OpenOptions options{.channel_c = 3};
        const Recording recording = opened(path, options);
        QCOMPARE(recording.channels.size(), 3u);
        QCOMPARE(read_all(recording).c, three);
        QCOMPARE(read_all(recording).d, two);
        options.channel_c = 4;
        QCOMPARE(open(path, options).error().code, ErrorCode::channel_out_of_range);
        QCOMPARE(open(folder.write("one.uff", uff58(one))).error().code,
                 ErrorCode::too_few_channels);
        QCOMPARE(open(folder.write("short.uff", two_channels({{1, 2}, {3, 4}}))).error().code,
                 ErrorCode::too_few_frames);
    }

    void a_file_cut_short_opens_with_what_is_there() {
        const Samples samples = wave(600);
        std::string bytes = two_channels(samples);
        // Ten lines of 6 values before the end of D, and a part of an eleventh.
        bytes.resize(bytes.size() - 7 - 11 * 79 + 30);
        const Folder folder;
        const Recording recording = opened(folder.write("cut.uff", bytes));
        QCOMPARE(recording.frames(), 600 - 66);
        const Diagnostic* early = find(recording, DiagnosticKind::file_ends_early);
        QVERIFY(early);
        QCOMPARE(early->args, (std::vector<MessageArg>{"600", "534"}));
        VYBEG_WITHIN(read_all(recording).d[533], samples.d[533], 0.5e-5);
    }

    void what_is_not_read_is_refused_by_name_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("word");
        const Samples samples = wave(10);
        const auto add = [&](const char* word, const std::function<void(UffText&)>& change) {
            UffText text;
            change(text);
            QTest::newRow(word) << QByteArray::fromStdString(two_channels(samples, text))
                                << QString(word);
        };
        add("complex values", [](UffText& t) { t.data_type = 5; });
        add("unevenly spaced values", [](UffText& t) { t.spacing = 0; });
        add("no time response", [](UffText& t) { t.function = 4; });
        for (const auto& [format, word] : {std::pair(1, "DEC"), std::pair(3, "IBM")}) {
            const UffBytes other{.float_format = format};
            QTest::newRow(word) << QByteArray::fromStdString(uff58b(samples.c, {}, other) +
                                                             uff58b(samples.d, {}, other))
                                << word;
        }
        QTest::newRow("another binary dataset")
            << QByteArray("    -1\n  2414b     1     2          11          80     0     0\n")
            << "2414b";
        QTest::newRow("nodes only")
            << QByteArray("    -1\n    15\n 1 0 0 8 0.0 0.0 0.0\n    -1\n") << "no time response";
    }

    void what_is_not_read_is_refused_by_name() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, word);
        const Folder folder;
        const auto recording = open(folder.write("run.uff", bytes.toStdString()));
        QVERIFY(!recording);
        QCOMPARE(recording.error().code, ErrorCode::format_unsupported);
        QVERIFY2(QString::fromStdString(english(recording.error())).contains(word),
                 english(recording.error()).c_str());
    }

    void a_header_that_lies_is_damage_data() {
        QTest::addColumn<QString>("count");
        for (const char* count : {"9", "11", "-1", "", "x", "9223372036854775808"}) {
            QTest::addRow("%s", count) << (*count != 0 ? QString(count) : QString(" "));
        }
    }

    void a_header_that_lies_is_damage() {
        QFETCH(QString, count);
        const UffText text{.count = count.toStdString()};
        const Folder folder;
        const auto recording = open(folder.write("run.uff", two_channels(wave(10), text)));
        QVERIFY(!recording);
        QCOMPARE(recording.error().code, ErrorCode::format_damaged);
    }

    void a_table_of_numbers_is_no_universal_file() {
        const Folder folder;
        const OpenOptions options{.rate_hz = 1000};
        const auto path = folder.write("run.txt", "-1 58\n58 2\n3 4\n5 6\n7 8\n");
        QCOMPARE(opened(path, options).frames(), 5);
    }

    void a_file_cut_anywhere_does_no_harm() {
        const Folder folder;
        const std::string bytes = two_channels(wave(30));
        const auto most = static_cast<std::int64_t>(bytes.size());
        const DamageCount cut = cut_everywhere(folder, bytes, {}, most);
        QCOMPARE(cut.wrong_status + cut.too_long + cut.unreadable, 0);
        VYBEG_MORE(cut.read, 100);
        VYBEG_MORE(cut.refused, 500);
        VYBEG_LESS(cut.slowest_ms, 2000);
    }

    void reading_stops_when_it_is_told_to() {
        const Folder folder;
        std::stop_source stop;
        stop.request_stop();
        const auto recording = open_recording(folder.write("run.uff", two_channels(wave(100000))),
                                              {}, JobControl(stop.get_token()));
        QVERIFY(!recording);
        QCOMPARE(recording.error().code, ErrorCode::interrupted);
    }
};

VYBEG_TEST(TestUffReader, threads)

}  // namespace test_uff_reader

#include "test_uff_reader.moc"
