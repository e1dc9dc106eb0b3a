#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_format.h"
#include "core/recording/text/text_header.h"
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/data/trade_files.h"
#include "tests/test_registry.h"

namespace test_text_dialects {

using namespace vybeg;
using namespace vybeg::test;

namespace {

OpenOptions at_1000_hz() {
    OpenOptions options{.rate_hz = 1000};
    return options;
}

// What every dialect of the table below writes: C and D at 1000 Hz, with negative, small and whole
// numbers.
const Samples expected{{1.5, -0.25, 0, 3e-5, 12, -7.125}, {2.5, 0.75, -1, 4, -1.25e-3, 100.5}};

// Writes the numbers above, from a template of one row: T, C and D stand for time and samples.
std::string table(const std::string& row, char decimal, const std::string& line_end) {
    const char* times[] = {"0", "0.001", "0.002", "0.003", "0.004", "0.005"};
    const char* c[] = {"1.5", "-0.25", "0", "3e-5", "12", "-7.125"};
    const char* d[] = {"2.5", "0.75", "-1", "4.0", "-1.25E-3", "+100.5"};
    std::string text;
    for (int i = 0; i < 6; ++i) {
        for (const char symbol : row) {
            std::string number = symbol == 'T'   ? times[i]
                                 : symbol == 'C' ? c[i]
                                 : symbol == 'D' ? d[i]
                                                 : std::string(1, symbol);
            if (number.size() > 1 || (symbol >= 'C' && symbol <= 'T')) {
                std::replace(number.begin(), number.end(), '.', decimal);
            }
            text += number;
        }
        text += line_end;
    }
    return text;
}

}  // namespace

class TestTextDialects : public QObject {
    Q_OBJECT

private slots:
    void every_dialect_gives_the_same_samples_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("format");
        const auto add = [](const char* name, const std::string& bytes, const char* format) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes) << QString("text, ") + format;
        };
        add("comma", table("C,D", '.', "\n"), "2 columns, comma");
        add("comma and blank", table("C, D", '.', "\n"), "2 columns, comma");
        add("tab", table("C\tD", '.', "\n"), "2 columns, tab");
        add("semicolon", table("C;D", '.', "\n"), "2 columns, semicolon");
        add("bar", table("C|D", '.', "\n"), "2 columns, bar");
        add("bars at the ends", table("| C | D |", '.', "\n"), "2 columns, bar");
        add("blank", table("C D", '.', "\n"), "2 columns, blanks");
        add("aligned by blanks", table("   C     D  ", '.', "\n"), "2 columns, blanks");
        add("decimal comma, semicolon", table("C;D", ',', "\n"),
            "2 columns, semicolon, decimal comma");
        add("decimal comma, semicolon and blank", table("C; D", ',', "\n"),
            "2 columns, semicolon, decimal comma");
        add("decimal comma, tab", table("C\tD", ',', "\n"), "2 columns, tab, decimal comma");
        add("decimal comma, blanks", table("C  D", ',', "\n"), "2 columns, blanks, decimal comma");
        add("with time", table("T,C,D", '.', "\n"), "3 columns, comma");
        add("with time, decimal comma", table("T;C;D", ',', "\n"),
            "3 columns, semicolon, decimal comma");
        add("CRLF", table("T,C,D", '.', "\r\n"), "3 columns, comma");
        add("CR", table("T,C,D", '.', "\r"), "3 columns, comma");
        add("byte order mark", "\xEF\xBB\xBF" + table("T,C,D", '.', "\r\n"), "3 columns, comma");
        add("UTF-16, little endian", utf16(table("T,C,D", '.', "\r\n"), false), "3 columns, comma");
        add("UTF-16, big endian", utf16(table("T;C;D", ',', "\n"), true),
            "3 columns, semicolon, decimal comma");
        add("delimiter behind the last field", table("T,C,D,", '.', "\n"), "3 columns, comma");
        add("semicolon behind the last field", table("T;C;D;", ',', "\n"),
            "3 columns, semicolon, decimal comma");
        add("tab behind the last field", table("T\tC\tD\t", '.', "\n"), "3 columns, tab");
        add("quoted", table("\"C\",\"D\"", '.', "\n"), "2 columns, comma");
        add("empty lines at the end", table("C,D", '.', "\n") + "\n\n  \n", "2 columns, comma");
        add("no line end at the end", table("C,D", '.', "\n") + "\x1A", "2 columns, comma");
        add("number of the row", "n,C,D\n" + table("1,C,D", '.', "\n"), "3 columns, comma");
        for (const char* mark : {"#", "%", "//", ";"}) {
            add(mark, std::string(mark) + " rate 5 6\n" + mark + "\n" + table("C,D", '.', "\n"),
                "2 columns, comma");
        }
        add("numbers in the header", "device 7, run 3\n2020,9\n4\n" + table("T,C,D", '.', "\n"),
            "3 columns, comma");
    }

    void every_dialect_gives_the_same_samples() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, format);
        const Folder folder;
        std::string text = bytes.toStdString();
        if (QString(QTest::currentDataTag()) == "number of the row") {
            // 1 in every row would be no counter.
            for (std::size_t at = 0, n = 1; (at = text.find("\n1,", at)) != std::string::npos;
                 ++n) {
                text.replace(++at, 1, std::to_string(n));
            }
        }
        const Recording recording = opened(folder.write("run", text), at_1000_hz());
        QCOMPARE(QString::fromStdString(english(recording.format)), format);
        QCOMPARE(recording.channels.size(), 2u);
        const Samples read = read_all(recording);
        QCOMPARE(read, expected);
        const bool timed = format.startsWith("text, 3 columns");
        const bool counted = QString(QTest::currentDataTag()) == "number of the row";
        QCOMPARE(recording.rate_from,
                 timed && !counted ? RateOrigin::time_column : RateOrigin::option);
        VYBEG_CLOSE(recording.rate_hz, 1000, 1e-9);
    }

    void missing_samples_are_nan_and_are_counted_data() {
        QTest::addColumn<QString>("field");
        QTest::addColumn<bool>("behind");  // as D at the end of the line
        for (const char* field : {"nan", "NaN", "NAN", "-nan", "inf", "-inf", "Inf", ""}) {
            QTest::addRow("C is '%s'", field) << QString(field) << false;
            QTest::addRow("D is '%s'", field) << QString(field) << true;
        }
    }

    void missing_samples_are_nan_and_are_counted() {
        QFETCH(QString, field);
        QFETCH(bool, behind);
        const Folder folder;
        const QString row = behind ? "3," + field : field + ",3";
        const QString text = "1,2\n1,2\n" + row + "\n1,2\n" + row + "\n1,2\n";
        const Recording recording = opened(folder.write("run", text.toStdString()), at_1000_hz());
        const Samples read = read_all(recording);
        QCOMPARE(worst_difference(behind ? read.d : read.c,
                                  behind ? std::vector<double>{2, 2, no_value, 2, no_value, 2}
                                         : std::vector<double>{1, 1, no_value, 1, no_value, 1}),
                 0.0);
        const Diagnostic* missing = find(recording, DiagnosticKind::missing_samples);
        QVERIFY(missing);
        QCOMPARE(missing->args, std::vector<MessageArg>{"2"});
        QCOMPARE(missing->first_frame, 2);
        QCOMPARE(missing->count, 2);
    }

    void what_the_first_row_lacks_is_missing_data() {
        QTest::addColumn<QString>("first");
        QTest::newRow("C") << "0,,2";
        QTest::newRow("D, behind the last delimiter") << "0,1,";
        QTest::newRow("both") << "0,,";
    }

    void what_the_first_row_lacks_is_missing() {
        QFETCH(QString, first);
        for (const char delimiter : {',', ';', '\t', '|'}) {
            QString text = "t,S_C,S_D\n" + first + '\n';
            for (int row = 1; row < 6; ++row) {
                text += QString("%1,1,2\n").arg(row * 1e-3);
            }
            const Folder folder;
            const Recording recording =
                opened(folder.write("run", text.replace(',', delimiter).toStdString()));
            QCOMPARE(recording.frames(), 6);
            QCOMPARE(recording.channels[1].name, std::string("S_D"));
            const Samples read = read_all(recording);
            QCOMPARE(std::isnan(read.c[0]), first.startsWith("0,,"));
            QCOMPARE(std::isnan(read.d[0]), first.endsWith(','));
            QCOMPARE(read.d[1], 2.0);
        }
    }

    void the_angle_of_a_wave_alone_is_a_whole_angle_log() {
        const Folder folder;
        const auto table = [&](const std::string& names) {
            std::string text = names + "\n";
            for (int row = 0; row < 20; ++row) {
                text += std::to_string(row * 1e-3) + ",1.5,2\n";
            }
            return open(folder.write("run", text));
        };
        for (const char* names : {"t,theta,amplitude", "t_s,theta_rad,quadrature_effort",
                                  "time (s),Theta (deg),Amplitude effort", "t,amplitude,angle"}) {
            const auto refused = table(names);
            QVERIFY2(!refused && refused.error().code == ErrorCode::holds_angle, names);
        }
        for (const char* names : {"t,C,D", "t,C,angle", "t,a_A,theta", "t,amplitude,quadrature"}) {
            QVERIFY2(table(names), names);
        }
    }

    void a_header_names_the_channels_data() {
        QTest::addColumn<QByteArray>("header");
        QTest::addColumn<QString>("row");
        QTest::addColumn<QString>("channels");
        QTest::addColumn<int>("lines_ignored");
        const auto add = [](const char* header, const char* row, const char* channels,
                            int ignored = 0) {
            QTest::newRow(header) << QByteArray(header) << QString(row) << QString(channels)
                                  << ignored;
        };
        add("", "%1,%2,%3", "1[] 2[]");
        add("t,C,D", "%1,%2,%3", "C[] D[]");
        add("t [s];S_C [V];S_D [mV]", "%1;%2;%3", "S_C[V] S_D[mV]");
        add("time (s),C (V),D (V)", "%1,%2,%3", "C[V] D[V]");
        add("t [s] S_C [V] S_D [V]", "%1 %2 %3", "S_C[V] S_D[V]");
        add("# t S_C S_D", "%1 %2 %3", "S_C[] S_D[]");
        add("#t,S_C,S_D", "%1,%2,%3", "S_C[] S_D[]");
        add("% t\tS_C\tS_D", "%1\t%2\t%3", "S_C[] S_D[]");
        add("Время, с;Канал C, В;Канал D, В", "%1;%2;%3", "Канал C[В] Канал D[В]");
        add("ВРЕМЯ;C;D", "%1;%2;%3", "C[] D[]");
        add("\xC2\xF0\xE5\xEC\xFF;\xD1;\xC4", "%1;%2;%3", "С[] Д[]");  // Windows-1251
        add("t,C,D\ns,V,mV", "%1,%2,%3", "C[V] D[mV]");
        add("x-axis,1,2\nsecond,Volt,Volt", "%1,%2,%3", "1[Volt] 2[Volt]");
        add("\"t\",\"C, left\",\"D\"", "%1,%2,%3", "C[left] D[]");
        add("Device: 7\nDate: 2020\n\nt,C,D", "%1,%2,%3", "C[] D[]", 2);
        add("two,names", "%1,%2,%3", "1[] 2[]", 1);
        add("t,,D", "%1,%2,%3", "1[] D[]");
        add("\tC\tD", "%1\t%2\t%3", "C[] D[]");
        add(";C;D", "%1;%2;%3", "C[] D[]");
        add("//t,C,D", "%1,%2,%3", "C[] D[]");
    }

    void a_header_names_the_channels() {
        QFETCH(QByteArray, header);
        QFETCH(QString, row);
        QFETCH(QString, channels);
        QFETCH(int, lines_ignored);
        const Folder folder;
        std::string text = header.toStdString() + "\n";
        for (int i = 0; i < 8; ++i) {
            text += row.arg(0.001 * i).arg(1 + 3 * i % 5).arg(2 + 7 * i % 6).toStdString() + "\n";
        }
        const Recording recording = opened(folder.write("run", text));
        QStringList found;
        for (const Channel& channel : recording.channels) {
            found << QString("%1[%2]").arg(QString::fromStdString(channel.name),
                                           QString::fromStdString(channel.unit));
        }
        QCOMPARE(found.join(' '), channels);
        VYBEG_CLOSE(recording.rate_hz, 1000, 1e-9);
        QCOMPARE(recording.rate_from, RateOrigin::time_column);
        const Diagnostic* ignored = find(recording, DiagnosticKind::text_lines_ignored);
        QCOMPARE(ignored ? ignored->args.at(0) : "0", std::to_string(lines_ignored));
    }

    void a_last_line_that_was_cut_off_is_left_out() {
        const Folder folder;
        const std::string rows = "0,1,2\n0.001,3,4\n0.002,5,6\n0.003,7,8\n0.004,9,10\n";
        for (const char* rest : {"0", "0.005", "0.005,1", "0.005,1,-", "0.005,1,2e"}) {
            const Recording recording = opened(folder.write("run", rows + rest));
            QCOMPARE(read_all(recording).d, (std::vector<double>{2, 4, 6, 8, 10}));
            QCOMPARE(recording.diagnostics.size(), 1u);
            QCOMPARE(recording.diagnostics[0].kind, DiagnosticKind::text_ends_within_row);
        }
        const Recording whole = opened(folder.write("run", rows + "0.005,1,2"));
        QCOMPARE(whole.frames(), 6);
        QVERIFY(whole.diagnostics.empty());
        // A line with its end, or a word, is no cut.
        for (const char* rest : {"0.005,1,-\n", "0.005,-,2", "0.005,1,x"}) {
            const auto refused = open(folder.write("run", rows + rest));
            QVERIFY(!refused);
            QCOMPARE(refused.error().code, ErrorCode::text_not_a_number);
        }
    }

    void segments_with_headers_of_their_own_are_told() {
        const Folder folder;
        const std::string head = "Channels\t2\nX_Value\tC\tD\n";
        std::string rows;
        for (int i = 0; i < 20; ++i) {
            rows +=
                QString("%1\t%2\t%3\n").arg(0.001 * i).arg(3 * i % 5).arg(7 * i % 6).toStdString();
        }
        const auto refused = open(folder.write("run.lvm", head + rows + "\n" + head + rows));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::text_segments);
        QCOMPARE(refused.error().args, std::vector<MessageArg>{"24"});
        const auto word = open(folder.write("run.lvm", head + rows + "oops\t1\t2\n" + rows));
        QVERIFY(!word);
        QCOMPARE(word.error().code, ErrorCode::text_not_a_number);
    }

    void blank_lines_and_comments_inside_the_data_are_passed_over() {
        const Folder folder;
        const auto path = folder.write(
            "run", "1,2\n\n3,4\n# touched the table here\n5,6\n% again\n7,8\n \n9,10\n");
        const Recording recording = opened(path, at_1000_hz());
        QCOMPARE(read_all(recording).c, (std::vector<double>{1, 3, 5, 7, 9}));
        const Diagnostic* ignored = find(recording, DiagnosticKind::text_lines_ignored);
        QVERIFY(ignored);
        QCOMPARE(ignored->args, std::vector<MessageArg>{"2"});
    }

    void the_length_of_comments_above_the_rows_does_not_count() {
        const Folder folder;
        std::string remarks;
        for (int k = 0; k < 20000; ++k) {
            remarks += "# remark number " + std::to_string(k) + " of the recorder\n";
        }
        const Recording recording =
            opened(folder.write("run", "# " + std::string(300000, 'x') + "\n" + remarks +
                                           "C,D\n1,2\n3,4\n5,6\n7,8\n9,10\n"),
                   at_1000_hz());
        QCOMPARE(read_all(recording).c, (std::vector<double>{1, 3, 5, 7, 9}));
        QCOMPARE(recording.channels[1].name, std::string("D"));
    }

    void rows_of_delimiters_among_times_are_passed_over_data() {
        QTest::addColumn<QString>("after");
        QTest::newRow("in the middle") << ",,\n0.200,7,8\n";
        QTest::newRow("above a comment") << "0.200,7,8\n,,\n# end\n";
        QTest::newRow("above a footer") << "0.200,7,8\n,,\nMax,,\n";
    }
    void rows_of_delimiters_among_times_are_passed_over() {
        QFETCH(QString, after);
        const Folder folder;
        std::string text = "t,C,D\n";
        for (int k = 0; k < 200; ++k) {
            text += "0." + std::to_string(1000 + k).substr(1) + ",1,2\n";
        }
        const Recording recording = opened(folder.write("run", text + after.toStdString()));
        const std::vector<double> c = read_all(recording).c;
        QCOMPARE(c.size(), std::size_t{201});
        QCOMPARE(c.back(), 7.0);
    }

    void any_two_columns_can_be_c_and_d_and_the_time_does_not_count() {
        const Folder folder;
        std::string text = "A,t,B,E\n";
        for (int i = 0; i < 6; ++i) {
            text += std::to_string(10 + i % 4) + ",0.00" + std::to_string(i) + "," +
                    std::to_string(20 + i % 4) + "," + std::to_string(30 + i % 4) + "\n";
        }
        const OpenOptions options{.channel_c = 3, .channel_d = 1};
        const Recording recording = opened(folder.write("run", text), options);
        QCOMPARE(recording.channels, (std::vector<Channel>{{"A", ""}, {"B", ""}, {"E", ""}}));
        QCOMPARE(read_all(recording).c, (std::vector<double>{30, 31, 32, 33, 30, 31}));
        QCOMPARE(read_all(recording).d, (std::vector<double>{10, 11, 12, 13, 10, 11}));
    }

    void a_field_as_a_number_data() {
        QTest::addColumn<QByteArray>("field");
        QTest::addColumn<bool>("decimal_comma");
        QTest::addColumn<QVariant>("value");
        const auto add = [](const char* field, bool comma, const QVariant& value) {
            QTest::addRow("%s, decimal %s", field, comma ? "comma" : "point")
                << QByteArray(field) << comma << value;
        };
        add("1.5", false, 1.5);
        add("1,5", true, 1.5);
        add("1.5", true, {});
        add("1,5", false, {});
        add("+.5", false, 0.5);
        add("-5.", false, -5.0);
        add("5,", true, {});
        add("1e-3", false, 1e-3);
        add("1,25E+02", true, 125.0);
        add("+-1", false, {});
        add("+", false, {});
        add("-", false, {});
        add("1 2", false, {});
        add("0x10", false, {});
        add("1e", false, {});
        add("12:30", false, {});
        add("1.2.3", false, {});
        add("0.1", false, 0.1);  // correctly rounded
        add("9007199254740993", false, 9007199254740992.0);
    }

    void a_field_as_a_number() {
        QFETCH(QByteArray, field);
        QFETCH(bool, decimal_comma);
        QFETCH(QVariant, value);
        const auto parsed =
            parse_field({field.data(), static_cast<std::size_t>(field.size())}, decimal_comma);
        QCOMPARE(parsed.has_value(), value.isValid());
        if (parsed) {
            QCOMPARE(*parsed, value.toDouble());
        }
    }

    void the_format_is_a_pure_function_of_the_first_lines() {
        const std::vector<std::string> lines = {"Gyro 12",      "t [ms];C [V];D [V]",
                                                "0,00;1,5;2,5", "0,03;1,25;-2",
                                                "0,06;nan;1",   "0,09;1;1"};
        const auto format = guess_text_format(lines);
        QVERIFY(format);
        QCOMPARE(*format, (TextFormat{.delimiter = ';',
                                      .decimal_comma = true,
                                      .lines_to_skip = 2,
                                      .above = {"Gyro 12", "t [ms]"},
                                      .columns = 3,
                                      .time_column = 0,
                                      .counter_column = -1,
                                      .time_unit_s = 1e-3,
                                      .own_time_unit_s = 1e-3,
                                      .header_lines_used = 1,
                                      .headings = {{"t", "ms"}, {"C", "V"}, {"D", "V"}}}));
        QVERIFY(!guess_text_format(std::vector<std::string>{"Dear Sir,", "1", "", "2", "x;y"}));
        QVERIFY(!guess_text_format({}));
    }

    void lines_longer_than_a_read_and_reads_that_end_inside_a_line_end_are_one_text() {
        // Files of many reads of 64 KiB, with every possible place of a boundary in "\r\n".
        const Folder folder;
        const std::string row = "0.125, -2.5\r\n";
        const std::size_t rows = 100000;
        for (std::size_t shift = 0; shift < row.size(); ++shift) {
            std::string text = std::string(shift, ' ') + "C, D\r\n";
            for (std::size_t i = 0; i < rows; ++i) {
                text += row;
            }
            const Samples read = read_all(opened(folder.write("run", text), at_1000_hz()));
            QCOMPARE(read.c, std::vector<double>(rows, 0.125));
            QCOMPARE(read.d, std::vector<double>(rows, -2.5));
            // A line end cut in two would be counted twice.
            const auto wrong = open(folder.write("run", text + "1, x\r\n"), at_1000_hz());
            QVERIFY(!wrong);
            QCOMPARE(wrong.error().args.at(0), std::to_string(rows + 2));
        }
    }
};

VYBEG_TEST(TestTextDialects, threads)

}  // namespace test_text_dialects

#include "test_text_dialects.moc"
