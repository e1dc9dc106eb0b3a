// What the engineer says of a text file, against files that the guess takes for something else.
#include "core/recording/samples/open_table.h"
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

namespace test_text_choice {

using namespace vybeg;
using namespace vybeg::test;

namespace {

OpenOptions said(const TextChoice& choice, std::optional<double> rate_hz = {}) {
    OpenOptions options{.rate_hz = rate_hz, .text = choice};
    return options;
}

OpenOptions scaled_by(double scale, std::optional<double> rate_hz = {}) {
    OpenOptions options = said({}, rate_hz);
    options.scale = scale;
    return options;
}

std::string number(double value, int decimals, char sign) {
    std::string text = QByteArray::number(value, 'f', decimals).toStdString();
    std::replace(text.begin(), text.end(), '.', sign);
    return text;
}

}  // namespace

class TestTextChoice : public QObject {
    Q_OBJECT

    Folder folder_;

    static void same(const Recording& recording, const Samples& expected) {
        const Samples read = read_all(recording);
        QCOMPARE(worst_difference(read, expected), 0.0);
    }

private slots:
    void a_delimiter_that_is_said_cuts_the_lines() {
        // A pair of numbers in each field: to the guess the blanks separate as well as the commas.
        const auto path = folder_.write("pairs.txt", "1,2;3\n5,6;7\n1,2;4\n5,6;8\n1,2;5\n");
        QCOMPARE(english(opened(path, said({}, 10)).format),
                 std::string("text, 2 columns, semicolon, decimal comma"));
        const auto wrong = open(path, said({.delimiter = ' '}, 10));
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().code, ErrorCode::text_no_table);
        QCOMPARE(wrong.error().args, (std::vector<MessageArg>{"--delimiter space", "1", "1,2;3"}));
        // Either sign may be the separator; the guess prefers the comma to blanks.
        const auto either = folder_.write("either.txt", "1,5 2\n3,5 4\n5,5 6\n7,5 8\n9,5 1\n");
        same(opened(either, said({.delimiter = ' '}, 10)),
             {{1.5, 3.5, 5.5, 7.5, 9.5}, {2, 4, 6, 8, 1}});
    }

    void a_decimal_comma_that_is_said_makes_one_number_of_two() {
        // Between commas and blanks: the guess sees three or four columns.
        const auto path =
            folder_.write("comma.txt", "1,5 2,5\n-1,25 0,5\n3,0 4,0\n5,5 6,5\n7,5 8,25\n");
        QCOMPARE(opened(path, said({.decimal_comma = true}, 10)).channels.size(), 2u);
        same(opened(path, said({.decimal_comma = true}, 10)),
             {{1.5, -1.25, 3, 5.5, 7.5}, {2.5, 0.5, 4, 6.5, 8.25}});
    }

    void numbers_with_commas_between_quotes_are_read() {
        const std::string text =
            "\"1,5\",\"2,5\"\n\"2,5\",\"-0,5\"\n\"1,0\",\"2\"\n\"3\",\"4,5\"\n"
            "\"1,5\",\"1,5\"\n";
        const Samples expected{{1.5, 2.5, 1, 3, 1.5}, {2.5, -0.5, 2, 4.5, 1.5}};
        const auto path = folder_.write("quotes.csv", text);
        same(opened(path, said({.delimiter = ',', .decimal_comma = true}, 10)), expected);
        same(opened(path, said({}, 10)), expected);
    }

    void a_point_that_is_said_refuses_commas() {
        const auto path = folder_.write("points.csv", "1,5;2,5\n1,5;2,5\n1,5;2,5\n1,5;2,5\n");
        const auto wrong = open(path, said({.delimiter = ';', .decimal_comma = false}, 10));
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().code, ErrorCode::text_no_table);
        QCOMPARE(wrong.error().args[0], std::string("--delimiter semicolon --decimal point"));
    }

    // Three lines of a calibration look like rows of the table below them.
    void lines_that_are_said_to_be_skipped_are() {
        std::string text = "9 8\n7 6\n5 4\n";
        for (int i = 0; i < 6; ++i) {
            text += std::to_string(i) + " " + std::to_string(-i) + "\n";
        }
        const auto path = folder_.write("calibration.txt", text);
        QCOMPARE(opened(path, said({}, 10)).frames(), 9);
        same(opened(path, said({.lines_to_skip = 3}, 10)),
             {{0, 1, 2, 3, 4, 5}, {0, -1, -2, -3, -4, -5}});
    }

    void the_line_behind_the_skipped_ones_must_be_a_row() {
        const auto path = folder_.write("names.csv", "a\nC,D\n1,2\n3,4\n5,6\n7,8\n9,1\n");
        QCOMPARE(opened(path, said({.lines_to_skip = 2}, 10)).channels[1].name, std::string("D"));
        const auto wrong = open(path, said({.lines_to_skip = 1}, 10));
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().code, ErrorCode::text_not_a_number);
        QCOMPARE(wrong.error().args, (std::vector<MessageArg>{"2", "1", "C"}));
    }

    void a_header_longer_than_what_the_guess_looks_at_is_skipped() {
        std::string text;
        constexpr int lines = 20000;
        for (int i = 0; i < lines; ++i) {
            text += "a line of the log of the instrument, before its table\n";
        }
        text += "S_C [V];S_D [V]\n1;2\n3;4\n5;6\n7;8\n9;10\n";
        const auto path = folder_.write("log.txt", text);
        QCOMPARE(open(path, said({}, 10)).error().code, ErrorCode::text_no_data);
        const Recording recording = opened(path, said({.lines_to_skip = lines + 1}, 10));
        same(recording, {{1, 3, 5, 7, 9}, {2, 4, 6, 8, 10}});
        QCOMPARE(recording.channels[0], (Channel{"S_C", "V"}));
        const auto wrong = open(path, said({.lines_to_skip = lines + 6}, 10));
        QCOMPARE(wrong.error().code, ErrorCode::text_lines_missing);
        QCOMPARE(wrong.error().args, (std::vector<MessageArg>{"20006", "20006"}));
    }

    void a_time_column_that_is_said_is_the_time_and_no_channel() {
        // The time stands last, without a name: to the guess it is a third channel.
        std::string text;
        Samples expected;
        for (int i = 0; i < 50; ++i) {
            expected.c.push_back(i % 7 - 3);
            expected.d.push_back(i % 5 - 2);
            text += number(expected.c.back(), 1, '.') + " " + number(expected.d.back(), 1, '.') +
                    " " + number(0.25 * i, 2, '.') + "\n";
        }
        const auto path = folder_.write("last.txt", text);
        QCOMPARE(open(path).error().code, ErrorCode::rate_unknown);
        const Recording recording = opened(path, said({.time_column = 3}));
        QCOMPARE(recording.channels.size(), 2u);
        QCOMPARE(recording.rate_from, RateOrigin::time_column);
        VYBEG_CLOSE(recording.rate_hz, 4, 1e-9);
        same(recording, expected);
        VYBEG_CLOSE(opened(path, said({.time_column = 3, .time_unit_s = 1e-3})).rate_hz, 4000,
                    1e-6);
        const auto wrong = open(path, said({.time_column = 4}));
        QCOMPARE(wrong.error().code, ErrorCode::column_out_of_range);
        QCOMPARE(wrong.error().args, (std::vector<MessageArg>{"4", "3"}));
    }

    void no_time_column_makes_a_channel_of_what_rises() {
        std::string text;
        for (int i = 0; i < 20; ++i) {
            text += number(0.001 * i, 3, '.') + "," + std::to_string(i % 3) + "," +
                    std::to_string(i % 4) + "\n";
        }
        const auto path = folder_.write("rises.csv", text);
        QCOMPARE(opened(path).rate_from, RateOrigin::time_column);
        const Recording recording = opened(path, said({.time_column = 0}, 500));
        QCOMPARE(recording.rate_hz, 500.0);
        QCOMPARE(recording.channels.size(), 3u);
        VYBEG_CLOSE(read_all(recording).c[19], 0.019, 1e-15);
    }

    void a_unit_of_time_makes_the_time_of_a_counter() {
        std::string text = "n,C,D\n";
        for (int i = 0; i < 20; ++i) {
            text += std::to_string(30 * i) + "," + std::to_string(i % 3) + ",1\n";
        }
        const auto path = folder_.write("counter.csv", text);
        QCOMPARE(open(path).error().code, ErrorCode::rate_unknown);
        const Recording recording = opened(path, said({.time_unit_s = 1e-6}));
        QCOMPARE(recording.channels.size(), 2u);
        VYBEG_CLOSE(recording.rate_hz, 1e6 / 30, 1e-6);
    }

    void samples_are_scaled_and_lose_the_unit_that_is_no_longer_theirs() {
        const auto path =
            folder_.write("scale.csv", "C [mV],D [mV]\n1,2\n3,\n5,1e308\n7,8\n9,10\n");
        const Recording recording = opened(path, scaled_by(-2, 10));
        same(recording, {{-2, -6, -10, -14, -18}, {-4, no_value, no_value, -16, -20}});
        QCOMPARE(recording.channels[0], (Channel{"C", ""}));
        OpenOptions options = scaled_by(1e-3, 10);
        options.unit = "V";
        QCOMPARE(opened(path, options).channels[1], (Channel{"D", "V"}));
        QCOMPARE(opened(path, options).read_with, std::string("--scale 0.001 --unit V"));
    }

    void uneven_times_are_scaled_as_well() {
        std::string text = "t,C,D\n";
        for (int i = 0; i < 200; ++i) {
            text += number(0.01 * i + (i % 2 == 0 ? 0 : 0.003), 4, '.') + ",1,-2\n";
        }
        const auto path = folder_.write("uneven.csv", text);
        const Recording plain = opened(path);
        QVERIFY(find(plain, DiagnosticKind::time_uneven));
        const Samples scaled = read_all(opened(path, scaled_by(3)));
        Samples expected = read_all(plain);
        for (std::vector<double>* values : {&expected.c, &expected.d}) {
            for (double& value : *values) {
                value *= 3;
            }
        }
        QCOMPARE(worst_difference(scaled, expected), 0.0);
    }

    void a_file_that_looks_like_something_else_is_read_as_text_when_it_is_said() {
        const auto path = folder_.write("uff.txt", "    -1\n    58\n1 2\n3 4\n5 6\n7 8\n9 1\n");
        QVERIFY(!open(path));
        same(opened(path, said({.lines_to_skip = 2}, 10)), {{1, 3, 5, 7, 9}, {2, 4, 6, 8, 1}});
        const auto wave = folder_.write("wave.wav", std::string("RIFF\0\0\0\0WAVEfmt ", 16));
        const auto wrong = open(wave, said({.delimiter = ','}, 10));
        QCOMPARE(wrong.error().code, ErrorCode::text_no_table);
    }

    void what_was_said_is_told_as_on_the_command_line() {
        OpenOptions options = said({.delimiter = '\t',
                                    .decimal_comma = true,
                                    .lines_to_skip = 4,
                                    .time_column = 0,
                                    .time_unit_s = 1e-6});
        options.scale = 0.25;
        options.unit = "mV";
        QCOMPARE(options_text(options),
                 std::string("--delimiter tab --decimal comma --skip-lines 4 --time-column none "
                             "--time-unit us --scale 0.25 --unit mV"));
        const OpenOptions raw{
            .raw = RawLayout{RawType::f32, true, 3, 512}, .variables = {"C", "D"}, .scale = 0.5};
        QCOMPARE(options_text(raw), std::string("--variables C,D --raw f32:be --raw-channels 3 "
                                                "--skip 512 --scale 0.5"));
        QCOMPARE(options_text({}), std::string());
    }

    void each_option_reads_its_own_text() {
        OpenOptions text = said({.delimiter = '|',
                                 .decimal_comma = false,
                                 .lines_to_skip = 12,
                                 .time_column = 3,
                                 .time_unit_s = 1e-9},
                                33333.125);
        text.scale = 1. / 3;
        text.channel_c = 4;
        text.channel_d = 2;
        text.unit = "V";
        const OpenOptions raw{.raw = RawLayout{RawType::f64, true, 5, 44},
                              .variables = {"XY", "", "fs"},
                              .scale = -1e-7};
        for (const OpenOptions& wanted : {OpenOptions(), text, raw}) {
            OpenOptions read;
            for (const SettingRow<OpenOptions>& row : open_settings()) {
                if (const std::string value = row.text(wanted); !value.empty()) {
                    QVERIFY2(row.read(value, read), row.name.c_str());
                }
            }
            QVERIFY2(read == wanted, options_text(read).c_str());
        }
    }

    void choices_that_cannot_be_are_refused_data() {
        QTest::addColumn<QString>("setting");
        QTest::addColumn<OpenOptions>("options");
        QTest::newRow("delimiter") << "--delimiter" << said({.delimiter = 'x'});
        QTest::newRow("below 0") << "--skip-lines" << said({.lines_to_skip = -1});
        QTest::newRow("too many") << "--skip-lines" << said({.lines_to_skip = 1'000'001});
        QTest::newRow("time column") << "--time-column" << said({.time_column = -1});
        QTest::newRow("time unit") << "--time-unit" << said({.time_unit_s = 60});
        QTest::newRow("scale 0") << "--scale" << scaled_by(0);
        QTest::newRow("scale nan") << "--scale" << scaled_by(no_value);
        OpenOptions both = said({.delimiter = ','});
        both.raw = RawLayout{};
        QTest::newRow("text and raw") << "--raw" << both;
    }
    void choices_that_cannot_be_are_refused() {
        QFETCH(QString, setting);
        QFETCH(OpenOptions, options);
        const auto path = folder_.write("any.csv", "1,2\n3,4\n5,6\n7,8\n9,10\n");
        const auto wrong = open(path, options);
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().code, ErrorCode::setting_invalid);
        QCOMPARE(QString::fromStdString(english(wrong.error().args[0])), setting);
    }
};

VYBEG_TEST(TestTextChoice)

}  // namespace test_text_choice

#include "test_text_choice.moc"
