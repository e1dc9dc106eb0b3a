// Units and rates as other programs write them above a table: every amplitude in the unit of C,
// every time in seconds, or a warning that names what is unknown.
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

namespace test_text_units {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr double rate_hz = 33333;
constexpr int rows = 60;

// A table of time (in units of `unit_s`; 0: the rows' numbers), C = 1.5 cos, D = 0.8 sin in units
// of `d_unit`.
std::string table(const std::string& header, double unit_s, double d_unit, char delimiter = ',',
                  bool decimal_comma = false) {
    QString text;
    for (int i = 0; i < rows; ++i) {
        const double phase = 1.0023 * i;
        QString row = QStringList{unit_s > 0 ? QString::number(i / rate_hz / unit_s, 'g', 17)
                                             : QString::number(i),
                                  QString::number(1.5 * std::cos(phase), 'g', 15),
                                  QString::number(0.8 * std::sin(phase) / d_unit, 'g', 15)}
                          .join(QChar(delimiter)) +
                      "\n";
        text += decimal_comma ? row.replace('.', ',') : row;
    }
    return header + "\n" + text.toStdString();
}

void check_samples(const Recording& recording) {
    VYBEG_CLOSE_RATIO(recording.rate_hz, rate_hz, 1e-9);
    const Samples samples = read_all(recording);
    QCOMPARE(samples.c.size(), std::size_t{rows});
    for (int i = 0; i < rows; ++i) {
        const auto k = static_cast<std::size_t>(i);
        VYBEG_CLOSE(samples.c[k], 1.5 * std::cos(1.0023 * i), 1e-12, "C");
        VYBEG_CLOSE(samples.d[k], 0.8 * std::sin(1.0023 * i), 1e-12, "D");
    }
}

}  // namespace

class TestTextUnits : public QObject {
    Q_OBJECT

private slots:
    void times_are_read_in_their_unit_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("unit_s");
        const auto row = [](const char* name, double unit_s) {
            QTest::newRow(name) << QString(name) << unit_s;
        };
        for (const char* name :
             {"Time ms", "t ms", "TimeMs", "Время мс", "Zeit ms", "Time-ms", "Time {ms}", "t_ms",
              "time (in ms)", "time [ms] abs", "Time (msecs)", "Time (millisec)", "Time (мсек)",
              "Время (миллисекунды)", "Zeit (Millisekunden)", "Time (ms.)"}) {
            row(name, 1e-3);
        }
        for (const char* name :
             {"Time (usecs)", "Time (microsecond)", "Time (µSec)", "Time (us.)", "Время (мксек)"}) {
            row(name, 1e-6);
        }
        row("Time (nanoseconds)", 1e-9);
        row("Time (ps)", 1e-12);
        row("Time (ks)", 1e3);
        row("Time (min)", 60);
        row("Время (мин)", 60);
        row("Time (h)", 3600);
        row("Time (days)", 86400);
        row("Time (s)", 1);
        row("Times", 1);
    }
    void times_are_read_in_their_unit() {
        QFETCH(QString, name);
        QFETCH(double, unit_s);
        const Folder folder;
        const std::string header = name.toStdString() + ",C (V),D (V)";
        const Recording recording = opened(folder.write("run.csv", table(header, unit_s, 1)));
        check_samples(recording);
        QVERIFY(!find(recording, DiagnosticKind::time_unit_unknown));
    }

    void names_beside_the_columns_are_still_theirs_data() {
        QTest::addColumn<QByteArray>("header");
        QTest::addColumn<QByteArray>("ends");
        QTest::addColumn<QChar>("delimiter");
        const auto row = [](const char* header, const char* ends, char delimiter) {
            QTest::newRow(header) << QByteArray(header) << QByteArray(ends) << QChar(delimiter);
        };
        row("Время (мс);C (В);D (В);Примечание", ";", ';');
        row("Time (ms),C (V),D (V),CH3 (V),CH4 (V)", ",,", ',');
        row("t [ms],C [V],D [V]\n------------------", "", ',');
        row("t [ms],C [V],D [V]\n\n======,======,======", "", ',');
        row("  t, ms   C, V   D, V", "", ' ');
        row("Время, мс;Канал1, В;Канал2, В", "", '\t');
        row("TIME(MS);C(V);D(V);", ";", ';');
    }
    void names_beside_the_columns_are_still_theirs() {
        QFETCH(QByteArray, header);
        QFETCH(QByteArray, ends);
        QFETCH(QChar, delimiter);
        const Folder folder;
        QByteArray text =
            QByteArray::fromStdString(table("", 1e-3, 1, delimiter.toLatin1())).mid(1);
        text.replace("\n", ends + "\n");
        const Recording recording =
            opened(folder.write("run.csv", (header + "\n" + text).toStdString()));
        check_samples(recording);
        QVERIFY(!recording.channels[0].unit.empty());
    }

    void two_exports_side_by_side_have_one_time() {
        const Folder folder;
        std::string text = "Time (ms),C (V),Time (ms),D (V)\n";
        for (int i = 0; i < rows; ++i) {
            const QByteArray time = QByteArray::number(1e3 * i / rate_hz, 'g', 17);
            text += time + "," + QByteArray::number(1.5 * std::cos(1.0023 * i), 'g', 15) + "," +
                    time + "," + QByteArray::number(0.8 * std::sin(1.0023 * i), 'g', 15) + "\n";
        }
        check_samples(opened(folder.write("run.csv", text)));
    }

    void channels_that_are_named_the_other_way_round_are_told() {
        const Folder folder;
        const auto path = folder.write("run.csv", table("t (s);S_D (V);S_C (V)", 1, 1, ';'));
        const Recording recording = opened(path);
        QVERIFY(find(recording, DiagnosticKind::channels_crossed));
        const OpenOptions exchanged{.channel_c = 2, .channel_d = 1};
        QVERIFY(!find(opened(path, exchanged), DiagnosticKind::channels_crossed));
    }

    void capitals_alone_are_no_megavolts() {
        const Folder folder;
        const Recording recording =
            opened(folder.write("run.csv", table("TIME(MS),C(V),D(MV)", 1e-3, 1e-3)));
        check_samples(recording);
    }

    void an_unknown_unit_of_time_is_named() {
        const Folder folder;
        const std::string text = table("Time (ticks),C (V),D (V)", 1, 1);
        const Recording recording = opened(folder.write("run.csv", text));
        const Diagnostic* unknown = find(recording, DiagnosticKind::time_unit_unknown);
        QVERIFY(unknown);
        QCOMPARE(unknown->args, std::vector<MessageArg>{"ticks"});
        OpenOptions options;
        options.text.emplace().time_unit_s = 1;
        QVERIFY(!find(opened(folder.write("run.csv", text), options),
                      DiagnosticKind::time_unit_unknown));
    }

    void a_unit_of_one_channel_is_named() {
        const Folder folder;
        for (const bool of_c : {true, false}) {
            const std::string header = of_c ? "t (s),C (mV),D" : "t (s),C,D (mV)";
            const Recording recording = opened(folder.write("run.csv", table(header, 1, 1)));
            const Diagnostic* alone = find(recording, DiagnosticKind::unit_of_one);
            QVERIFY(alone);
            QCOMPARE(alone->args, (of_c ? std::vector<MessageArg>{"C", "mV", "D"}
                                        : std::vector<MessageArg>{"D", "mV", "C"}));
        }
        for (const char* header : {"t (s),C (V),D (V)", "t (s),C,D"}) {
            QVERIFY(!find(opened(folder.write("run.csv", table(header, 1, 1))),
                          DiagnosticKind::unit_of_one));
        }
    }

    void a_rate_above_unnamed_columns_names_none() {
        const Folder folder;
        std::string text = "# fs=33.333 kHz\n";
        for (int i = 0; i < rows; ++i) {
            text += QString("%1 %2\n")
                        .arg(1.5 * std::cos(1.0023 * i), 0, 'g', 15)
                        .arg(0.8 * std::sin(1.0023 * i), 0, 'g', 15)
                        .toStdString();
        }
        const Recording recording = opened(folder.write("run.txt", text));
        check_samples(recording);
        QCOMPARE(recording.channels, (std::vector<Channel>{{"1", ""}, {"2", ""}}));
        QVERIFY(!find(recording, DiagnosticKind::unit_of_one));
    }

    void separators_of_thousands_are_named() {
        const Folder folder;
        std::string text = "t;C;D\n";
        for (int i = 0; i < rows; ++i) {
            text += std::to_string(i) + ".5;-7,298." + std::to_string(100 + i) + ";41.25\n";
        }
        const auto refused = open(folder.write("run.csv", text));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::text_thousands);
        // Two columns of integers and numbers.
        std::string columns = "C,D\n";
        for (int i = 0; i < rows; ++i) {
            columns += std::to_string(i % 7) + "," + std::to_string(100 + i) + ".25\n";
        }
        QCOMPARE(opened(folder.write("run.csv", columns), {.rate_hz = rate_hz}).frames(), rows);
    }

    void decimal_commas_between_commas_are_refused_data() {
        QTest::addColumn<QByteArray>("rows");
        QTest::addColumn<bool>("refused");
        QTest::newRow("three") << QByteArray("0,000030,1,234500,-0,678900\n") << true;
        QTest::newRow("two") << QByteArray("1,234500,-0,078900\n") << true;
        // Counts of a converter, as integers are written.
        QTest::newRow("integers") << QByteArray("0,30,1234,500\n") << false;
        QTest::newRow("zeros") << QByteArray("0,0,1,0\n") << false;
        QTest::newRow("points") << QByteArray("0.1,05,1.5,00\n") << false;
        QTest::newRow("signs") << QByteArray("1,-05,1,-07\n") << false;
    }
    void decimal_commas_between_commas_are_refused() {
        QFETCH(QByteArray, rows);
        QFETCH(bool, refused);
        const Folder folder;
        const auto path = folder.write("run.csv", rows.repeated(20).toStdString());
        OpenOptions options{.rate_hz = rate_hz};
        const auto recording = open(path, options);
        QCOMPARE(!recording && recording.error().code == ErrorCode::text_decimal_commas, refused);
        // Said to be so, it is read so.
        options.text.emplace().delimiter = ',';
        options.text->decimal_comma = false;
        const auto said = open(path, options);
        QVERIFY(said || said.error().code != ErrorCode::text_decimal_commas);
    }

    void d_comes_in_the_unit_of_c_data() {
        QTest::addColumn<QByteArray>("header");
        QTest::addColumn<double>("d_unit");
        QTest::addColumn<char>("delimiter");
        const auto row = [](const char* name, const QByteArray& header, double d_unit,
                            char delimiter = ',') {
            QTest::newRow(name) << header << d_unit << delimiter;
        };
        row("blank", "Time (s),C V,D mV", 1e-3);
        row("underscore", "Time_s,C_V,D_mV", 1e-3);
        row("words", "Time (s),CH1 Volt,CH2 mVolt", 1e-3);
        row("units alone", "Time (s),V,mV", 1e-3);
        row("coupling", "Time (s),C (V) DC,D (mV) DC", 1e-3);
        row("coupling within", "Time (s),C (V DC),D (mV DC)", 1e-3);
        row("braces", "Time {s},C {V},D {mV}", 1e-3);
        row("line of units", "Time,C,D\ns,V DC,mV DC", 1e-3);
        row("cp1251",
            "\xC2\xF0\xE5\xEC\xFF;\xCA\xE0\xED\xE0\xEB 1;\xCA\xE0\xED\xE0\xEB "
            "2\n\xF1;\xC2;\xEC\xC2",
            1e-3, ';');
        row("cp1252", "Time;C;D\ns;V;\xB5V", 1e-6, ';');
        row("letters that number channels", "Time (s),Channel A,Channel B", 1);
        row("Cyrillic ones", "Time (s),Канал В,Канал А", 1);
    }
    void d_comes_in_the_unit_of_c() {
        QFETCH(QByteArray, header);
        QFETCH(double, d_unit);
        QFETCH(char, delimiter);
        const Folder folder;
        const std::string text = table(header.toStdString(), 1, d_unit, delimiter);
        const Recording recording = opened(folder.write("run.csv", text));
        check_samples(recording);
        QCOMPARE(find(recording, DiagnosticKind::unit_converted) != nullptr, d_unit != 1);
        QVERIFY(!find(recording, DiagnosticKind::units_differ));
    }

    void a_column_of_another_quantity_is_no_time() {
        const Folder folder;
        const auto path = folder.write("run.csv", table("Temp (degC),C (V),D (V)", 1, 1));
        const auto refused = open_recording(path, {}, {});
        QVERIFY(!refused);
        QVERIFY(refused.error().code == ErrorCode::rate_unknown);
        const OpenOptions options{.rate_hz = rate_hz};
        check_samples(opened(path, options));
        check_samples(opened(folder.write(
            "run2.csv", "Sample rate: 33333 Hz\n" + table("Ramp (V),C (V),D (V)", 2, 1))));
    }

    void a_rate_above_the_table_that_contradicts_its_times_is_refused() {
        const Folder folder;
        const std::string times_in_ms = table("Time,C (V),D (V)", 1e-3, 1);
        const auto path = folder.write("run.csv", "Sample Rate: 33333 Hz\n" + times_in_ms);
        const auto refused = open(path);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::rates_differ);
        QCOMPARE(refused.error().args, (std::vector<MessageArg>{"33333", "33.333"}));
        // The unit of the times, or the rate that holds, settles it.
        const OpenOptions in_ms{.text = TextChoice{.time_unit_s = 1e-3}};
        check_samples(opened(path, in_ms));
        const OpenOptions stated{.rate_hz = 33333};
        VYBEG_CLOSE_RATIO(opened(path, stated).rate_hz, rate_hz, 1e-9);
        for (const char* agreeing : {"Sample Rate: 33333 Hz\n", "Sample Rate: 33.3 kHz\n"}) {
            QVERIFY(open(folder.write("ok.csv", agreeing + table("Time,C,D", 1, 1))));
        }
    }

    void a_rate_needs_no_colon_data() {
        QTest::addColumn<QString>("line");
        for (const char* line :
             {"Sample rate 33333 Hz", "# Sample rate 33.333 kHz", "Fs=33333", "fs = 33333 Hz",
              "Sampling frequency 33333", "Частота дискретизации 33333 Гц"}) {
            QTest::newRow(line) << line;
        }
    }
    void a_rate_needs_no_colon() {
        QFETCH(QString, line);
        const Folder folder;
        check_samples(opened(folder.write(
            "run.csv", line.toStdString() + "\n" + table("Ramp (V),C (V),D (V)", 2, 1))));
    }

    void thousands_in_a_rate_are_refused_data() {
        QTest::addColumn<QString>("rate");
        QTest::addColumn<bool>("decimal_comma");
        QTest::addColumn<bool>("refused");
        const auto row = [](const char* rate, bool decimal_comma, bool refused) {
            QTest::newRow(rate) << rate << decimal_comma << refused;
        };
        row("Sample Rate: 33,333 Hz", false, true);
        row("Sample Rate: 33,333.0 Hz", false, true);
        row("Abtastrate: 33.333 Hz", true, true);
        row("Sample Rate: 33.333 kHz", false, false);
        row("Abtastrate: 33,333 kHz", true, false);
        row("Sample Rate: 33,333 kHz", false, false);
        row("Input Rate In kHz: 33,333", false, false);
    }
    void thousands_in_a_rate_are_refused() {
        QFETCH(QString, rate);
        QFETCH(bool, decimal_comma);
        QFETCH(bool, refused);
        const Folder folder;
        const std::string text = table("No;C (V);D (V)", 0, 1, ';', decimal_comma);
        const auto path = folder.write("run.csv", rate.toStdString() + "\n" + text);
        if (!refused) {
            check_samples(opened(path));
            return;
        }
        const auto recording = open(path);
        QVERIFY(!recording);
        QCOMPARE(recording.error().code, ErrorCode::rate_unknown);
    }

    void dates_of_a_spreadsheet_are_days() {
        const Folder folder;
        QString text("Date;c;d\n");
        for (int k = 0; k < 400; ++k) {
            text += QString("%1;%2;1\n").arg(46112 + k / 9600. / 86400, 0, 'f', 12).arg(k % 7);
        }
        const Recording recording = opened(folder.write("run.csv", text.toStdString()));
        QCOMPARE(recording.frames(), 400);
        VYBEG_WITHIN(recording.rate_hz / 9600, 1, 5 * recording.rate_relative_sd + 1e-6);
        VYBEG_LESS(recording.rate_relative_sd, 2e-4);
    }

    // "0.000104" is what is left of 1/9600 s, "0.000125" is 1/8000 s.
    void a_step_of_few_digits_leaves_the_rate_open_data() {
        QTest::addColumn<QString>("step");
        QTest::addColumn<double>("relative_sd");
        QTest::newRow("0.000104") << "0.000104" << 1e-6 / std::sqrt(12) / 1.04e-4;
        QTest::newRow("1.04E-04") << "1.04E-04" << 1e-6 / std::sqrt(12) / 1.04e-4;
        QTest::newRow("0.104 ms") << "0.104 ms" << 1e-3 / std::sqrt(12) / 0.104;
        QTest::newRow("0.000125") << "0.000125" << 1e-9 / std::sqrt(12) / 1.25e-4;
        QTest::newRow("2.5E-5") << "2.5E-5" << 1e-10 / std::sqrt(12) / 2.5e-5;
    }
    void a_step_of_few_digits_leaves_the_rate_open() {
        QFETCH(QString, step);
        QFETCH(double, relative_sd);
        const Folder folder;
        const Recording recording =
            opened(folder.write("run.csv", "Sample Interval: " + step.toStdString() + "\n" +
                                               table("No,C (V),D (V)", 0, 1)));
        VYBEG_CLOSE_RATIO(recording.rate_relative_sd, relative_sd, 1e-6);
    }

    void the_unit_of_a_step_may_stand_in_a_line_of_its_own() {
        const Folder folder;
        const QString step = QString::number(1e3 / rate_hz, 'g', 12);
        for (const char* head : {"HResolution,%1\nHUnit,ms\n", "Delta_X,%1\nX_Unit,ms\n"}) {
            const std::string text = QString(head).arg(step).toStdString();
            check_samples(opened(folder.write("run.csv", text + table("No,C (V),D (V)", 0, 1))));
        }
    }

    void marks_of_an_overload_are_no_samples_data() {
        QTest::addColumn<QString>("mark");
        for (const char* mark : {"9.9E+37", "9.99E+37", "-1E+38", "3.4e38", "OVLD"}) {
            QTest::newRow(mark) << mark;
        }
    }
    void marks_of_an_overload_are_no_samples() {
        QFETCH(QString, mark);
        const Folder folder;
        QString text = QString::fromStdString(table("Time (s),C (V),D (V)", 1, 1));
        const qsizetype line = text.indexOf('\n', text.indexOf('\n', text.indexOf('\n') + 1) + 1);
        const qsizetype last = text.lastIndexOf(',', line);
        text.replace(last + 1, line - last - 1, mark);
        const Recording recording = opened(folder.write("run.csv", text.toStdString()));
        const Diagnostic* beyond = find(recording, DiagnosticKind::over_range);
        QVERIFY(beyond);
        QCOMPARE(beyond->args, (std::vector<MessageArg>{"D", "1"}));
        QVERIFY(std::isnan(read_all(recording).d[1]));
    }

    void samples_in_rows_are_refused_at_once() {
        std::string line = "1";
        for (int i = 1; i < 60000; ++i) {
            line += "," + std::to_string(i % 7);
        }
        const Folder folder;
        const auto refused =
            open_recording(folder.write("wide.csv", line + "\n" + line + "\n"), {}, {});
        QVERIFY(!refused);
        QVERIFY(refused.error().code == ErrorCode::format_unsupported);
        QVERIFY(QString::fromStdString(english(refused.error().args[1])).contains("60000"));
    }
};

VYBEG_TEST(TestTextUnits)

}  // namespace test_text_units

#include "test_text_units.moc"
