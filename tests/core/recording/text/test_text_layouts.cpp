// Files after the layouts of oscilloscopes, data acquisition programs and spreadsheets, each with
// the channels, units, rate and samples that it holds (tests/data/text/expected.json).
#include "core/recording/samples/text_fields.h"
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <array>
#include <set>
#include <utility>

namespace test_text_layouts {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr std::size_t layouts_wanted = 65;

std::filesystem::path data_file(const QString& name) {
    return std::filesystem::path(VYBEG_TEST_DATA) / "text" / name.toStdString();
}

QJsonArray layouts() {
    QFile file(QString::fromStdString(data_file("expected.json").string()));
    if (!file.open(QIODevice::ReadOnly)) {
        qFatal("tests/data/text/expected.json cannot be read");
    }
    return QJsonDocument::fromJson(file.readAll()).object()["layouts"].toArray();
}

QString channels_text(const Recording& recording) {
    QStringList texts;
    for (const Channel& channel : recording.channels) {
        texts << QString::fromStdString(channel.name + " [" + channel.unit + "]");
    }
    return texts.join(", ");
}

// The first sample that differs by more than rounding, and both values; empty where none does.
QString difference(const std::vector<double>& read, const QJsonArray& expected) {
    if (read.size() != static_cast<std::size_t>(expected.size())) {
        return QString("%1 samples instead of %2").arg(read.size()).arg(expected.size());
    }
    for (int i = 0; i < expected.size(); ++i) {
        const double value = read[static_cast<std::size_t>(i)];
        const bool missing = expected[i].isNull();
        // 1e-6 V is half a digit of the coarsest of the files, whose units are converted.
        const double tolerance = 1e-6 * (1 + std::abs(expected[i].toDouble()));
        if (std::isnan(value) != missing ||
            (!missing && std::abs(value - expected[i].toDouble()) > tolerance)) {
            return QString("sample %1 is %2 instead of %3")
                .arg(i)
                .arg(value)
                .arg(missing ? QString("nan") : QString::number(expected[i].toDouble()));
        }
    }
    return {};
}

constexpr int table_rows = 64;

// A table of times, cos and sin / 2 as the number of its layout says: delimiter and decimal sign,
// place of a column of words, line ends, delimiters behind each row and below the last one, names.
QString table(int layout) {
    const auto pick = [&layout](int count) {
        const int picked = layout % count;
        layout /= count;
        return picked;
    };
    const std::array dialects{std::pair(',', false), std::pair(';', false), std::pair(';', true),
                              std::pair('\t', false), std::pair('\t', true)};
    const auto [delimiter, comma] = dialects[static_cast<std::size_t>(pick(5))];
    // None, first, between, last; a comment in the first row, in a later one.
    const int words = pick(6);
    const QString ends = pick(2) == 0 ? "\n" : "\r\n";
    const bool trailing = pick(2) == 1;
    const bool closing = pick(2) == 1;
    const QStringList names =
        QStringList{"Time, s|C, V|D, V", "t|C|D", "Время|Канал 1|Канал 2"}[pick(3)].split('|');
    QString text;
    const auto add = [&, delimiter = delimiter](QStringList fields, const QString& word) {
        if (words > 0) {
            fields.insert(words == 1 ? 0 : words == 2 ? 2 : 3, word);
        }
        text += fields.join(delimiter) + (trailing ? QString(delimiter) : QString()) + ends;
    };
    QStringList heading;
    for (const QString& name : names) {
        heading << (name.contains(delimiter) ? '"' + name + '"' : name);
    }
    add(heading, "State");
    for (int k = 0; k < table_rows; ++k) {
        QStringList fields;
        for (const double value : {k * 1e-3, std::cos(0.7 * k), 0.5 * std::sin(0.7 * k)}) {
            fields << QString::number(value, 'f', 6).replace('.', comma ? ',' : '.');
        }
        add(fields, words < 4 ? "locked" : k == (words == 4 ? 0 : 40) ? "knock" : "");
    }
    for (int k = 0; closing && k < 2; ++k) {
        text += QString(3, delimiter) + ends;
    }
    return text;
}

}  // namespace

class TestTextLayouts : public QObject {
    Q_OBJECT

private slots:
    void there_are_as_many_layouts_as_wanted_and_each_has_its_file() {
        std::set<QString> files;
        for (const QJsonValue& layout : layouts()) {
            const QString name = layout["file"].toString();
            QVERIFY2(std::filesystem::exists(data_file(name)), qPrintable(name));
            files.insert(name);
        }
        VYBEG_AT_LEAST(files.size(), layouts_wanted);
    }

    void every_layout_gives_its_channels_units_rate_and_samples_data() {
        QTest::addColumn<QJsonObject>("layout");
        for (const QJsonValue& layout : layouts()) {
            QTest::newRow(qPrintable(layout["file"].toString())) << layout.toObject();
        }
    }

    void every_layout_gives_its_channels_units_rate_and_samples() {
        QFETCH(QJsonObject, layout);
        OpenOptions options;
        if (layout.contains("rate_option_hz")) {
            options.rate_hz = layout["rate_option_hz"].toDouble();
        }
        const auto recording = open(data_file(layout["file"].toString()), options);
        QVERIFY2(recording, recording ? "" : english(recording.error()).c_str());

        QStringList channels;
        for (const QJsonValue& channel : layout["channels"].toArray()) {
            channels << channel["name"].toString() + " [" + channel["unit"].toString() + "]";
        }
        QCOMPARE(channels_text(*recording), channels.join(", "));

        const double rate = layout["rate_hz"].toDouble();
        const double sd = recording->rate_relative_sd;
        const double allowed_sd = layout["rate_relative_sd_at_most"].toDouble();
        QCOMPARE(QString::fromStdString(rate_origin_name(recording->rate_from)),
                 layout["rate_from"].toString());
        VYBEG_AT_LEAST(sd, 0);
        VYBEG_AT_MOST(sd, allowed_sd);
        // Rounding leaves an interval open that reaches two deviations at most.
        VYBEG_WITHIN(recording->rate_hz / rate, 1, 2.001 * sd + 1e-9,
                     qPrintable(QString("rate %1").arg(rate)));

        const Samples samples = read_all(*recording);
        QCOMPARE(difference(samples.c, layout["c"].toArray()), QString());
        QCOMPARE(difference(samples.d, layout["d"].toArray()), QString());

        QStringList warnings;
        for (const Diagnostic& diagnostic : recording->diagnostics) {
            if (diagnostic.kind != DiagnosticKind::text_lines_ignored) {
                warnings << QString::fromStdString(kind_name(diagnostic.kind));
            }
        }
        QStringList expected;
        for (const QJsonValue& warning : layout["warnings"].toArray()) {
            expected << warning.toString();
        }
        QCOMPARE(warnings.join(", "), expected.join(", "));
    }

    // What table programs, loggers and their users leave in a table, in all combinations.
    void words_and_delimiters_beside_the_numbers_change_nothing() {
        const Folder folder;
        constexpr int layouts = 5 * 6 * 2 * 2 * 2 * 3;
        for (int layout = 0; layout < layouts; ++layout) {
            const QByteArray text = table(layout).toUtf8();
            const std::string at = "layout " + std::to_string(layout);
            const auto recording = open(folder.write("table.csv", text.toStdString()), {});
            QVERIFY2(recording, recording ? "" : (at + english(recording.error())).c_str());
            QVERIFY2(recording->frames() == table_rows, at.c_str());
            VYBEG_WITHIN(recording->rate_hz, 1000, 1e-3);
            const Samples samples = read_all(*recording);
            for (std::size_t k = 0; k < table_rows; ++k) {
                const auto turn = 0.7 * static_cast<double>(k);
                QVERIFY2(std::abs(samples.c[k] - std::cos(turn)) < 1e-6, at.c_str());
                QVERIFY2(std::abs(samples.d[k] - 0.5 * std::sin(turn)) < 1e-6, at.c_str());
            }
        }
    }

    void units_without_a_known_ratio_are_warned_of_and_not_converted() {
        const Folder folder;
        for (const char* units : {"V,g", "V,m/s", "V,counts", "mV,A"}) {
            const QStringList unit = QString(units).split(',');
            const std::string text =
                QString("t [s],C [%1],D [%2]\n").arg(unit[0], unit[1]).toStdString() +
                rows("T,C,D\n");
            const Recording recording = opened(folder.write("run.csv", text));
            QCOMPARE(read_all(recording).d[3], 2.5 * 3);
            const Diagnostic* differ = find(recording, DiagnosticKind::units_differ);
            QVERIFY2(differ, units);
            QCOMPARE(differ->args, (std::vector<MessageArg>{"C", unit[0].toStdString(), "D",
                                                            unit[1].toStdString()}));
        }
    }

    void d_is_converted_to_the_unit_of_c_whichever_channels_they_are() {
        const Folder folder;
        const std::string text = "t [s],C [V],D [mV]\n" + rows("T,C,D\n");
        const OpenOptions swapped{.channel_c = 2, .channel_d = 1};
        const Recording plain = opened(folder.write("run.csv", text));
        const Recording other = opened(folder.write("run.csv", text), swapped);
        QCOMPARE(read_all(plain).c[3], 1.5 * 3);
        VYBEG_CLOSE(read_all(plain).d[3], 2.5e-3 * 3, 1e-15);
        QCOMPARE(read_all(other).c[3], 2.5 * 3);
        VYBEG_CLOSE(read_all(other).d[3], 1.5e3 * 3, 1e-9);
        QCOMPARE(find(other, DiagnosticKind::unit_converted)->args,
                 (std::vector<MessageArg>{"C", "V", "mV"}));
    }

    void channels_whose_own_times_differ_are_refused_together() {
        const Folder folder;
        std::string text = "X_Value,C,X_Value,D,E\n";
        for (int i = 0; i < 12; ++i) {
            text += QString("%1,%2,%3,%4,%5\n")
                        .arg(i * 1e-3)
                        .arg(i % 5)
                        .arg(i * 2e-3)
                        .arg(i % 3)
                        .arg(i % 4)
                        .toStdString();
        }
        const auto path = folder.write("run.csv", text);
        const auto wrong = open(path);
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().code, ErrorCode::parts_differ);
        // D and E share their times, which are those of their rate.
        const OpenOptions options{.channel_c = 2, .channel_d = 3};
        VYBEG_CLOSE(opened(path, options).rate_hz, 500, 0.5);
    }

    void a_header_that_contradicts_itself_or_the_times_gives_no_rate() {
        const Folder folder;
        const std::string two = "# sample rate: 1000 Hz\n# dt: 0.002 s\nC,D\n" + rows("C,D\n");
        const auto wrong = open(folder.write("two.csv", two));
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().code, ErrorCode::rate_unknown);
        const std::string times = "# sample rate: 2000 Hz\nt,C,D\n" + rows("T,C,D\n");
        const auto refused = open(folder.write("times.csv", times));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::rates_differ);
    }

    void lines_behind_the_table_are_passed_over_and_counted_data() {
        QTest::addColumn<QString>("behind");
        QTest::addColumn<int>("lines");
        QTest::newRow("words") << "End of data\n" << 1;
        QTest::newRow("without line end") << "End of data" << 1;
        QTest::newRow("totals") << "Total,1.25,3.5\n" << 1;
        QTest::newRow("statistics") << "\nMean,,0.1,0.2\nSD,,1.5,2.5\n\n" << 2;
        QTest::newRow("comments") << "# stopped by hand\n# 12:30\n" << 2;
        QTest::newRow("Russian") << "Конец записи\r\n" << 1;
    }
    void lines_behind_the_table_are_passed_over_and_counted() {
        QFETCH(QString, behind);
        QFETCH(int, lines);
        const Folder folder;
        const Recording recording =
            opened(folder.write("run.csv", "t,C,D\n" + rows("T,C,D\n") + behind.toStdString()));
        const Recording plain = opened(folder.write("plain.csv", "t,C,D\n" + rows("T,C,D\n")));
        QCOMPARE(recording.frames(), plain.frames());
        QCOMPARE(recording.rate_hz, plain.rate_hz);
        const Diagnostic* passed = find(recording, DiagnosticKind::text_lines_ignored);
        QVERIFY(passed);
        QCOMPARE(passed->args, (std::vector<MessageArg>{std::to_string(lines)}));
    }

    void numbers_of_rows_need_no_name() {
        const Folder folder;
        std::string text = "\"t\" \"C\" \"D\"\n";
        for (int i = 0; i < 30; ++i) {
            text += QString("\"%1\" %2 %3 %4\n")
                        .arg(i + 1)
                        .arg(i * 1e-3)
                        .arg(std::cos(0.7 * i))
                        .arg(std::sin(0.7 * i))
                        .toStdString();
        }
        const Recording recording = opened(folder.write("run.txt", text));
        QCOMPARE(channels_text(recording), QString("C [], D []"));
        VYBEG_CLOSE(recording.rate_hz, 1000, 1e-3);
        VYBEG_CLOSE(read_all(recording).c[7], std::cos(4.9), 1e-5);
    }

    void midnight_passes_between_a_date_and_a_time_in_columns_of_their_own() {
        const Folder folder;
        std::string text = "Date;Time;C;D\n";
        for (int i = 0; i < 40; ++i) {
            const int ms = 59900 + 10 * i;  // from 23:59 on
            const QTime time = QTime(23, 59).addMSecs(ms);
            text += QString("%1;%2;%3;%4\n")
                        .arg(ms < 60000 ? "31.12.2025" : "01.01.2026")
                        .arg(time.toString("HH:mm:ss.zzz"))
                        .arg(std::cos(0.7 * i))
                        .arg(std::sin(0.7 * i))
                        .toStdString();
        }
        const Recording recording = opened(folder.write("run.csv", text));
        VYBEG_CLOSE(recording.rate_hz, 100, 1e-6);
        QCOMPARE(recording.frames(), 40);
    }

    void whole_numbers_that_rise_by_one_and_times_again_are_no_channels() {
        const Folder folder;
        std::string text = "t,C,counted,clock,D\n";
        for (int i = 0; i < 12; ++i) {
            text += QString("%1,%2,%3,%1,%4\n")
                        .arg(i * 1e-3)
                        .arg(i % 5)
                        .arg(100 + i)
                        .arg(i % 3)
                        .toStdString();
        }
        const Recording recording = opened(folder.write("run.csv", text));
        QCOMPARE(channels_text(recording), QString("C [], D []"));
        // Of two columns both are channels, whatever they hold.
        const OpenOptions at_10_hz{.rate_hz = 10};
        const auto ramp = folder.write("ramp.csv", "1,9\n2,8\n3,8\n4,9\n5,7\n6,9\n");
        QCOMPARE(opened(ramp, at_10_hz).channels.size(), 2u);
    }

    void fields_that_are_numbers_in_their_own_way_data() {
        QTest::addColumn<QByteArray>("field");
        QTest::addColumn<double>("value");
        QTest::newRow("Fortran") << QByteArray("-1.5D+03") << -1500.0;
        QTest::newRow("Fortran, small") << QByteArray("2d-1") << 0.2;
        QTest::newRow("minus") << QByteArray(
                                      "\xE2\x88\x92"
                                      "2.5")
                               << -2.5;
        QTest::newRow("minus in the exponent") << QByteArray(
                                                      "1e\xE2\x88\x92"
                                                      "2")
                                               << 0.01;
        const double infinite = std::numeric_limits<double>::infinity();
        QTest::newRow("infinity sign") << QByteArray("\xE2\x88\x9E") << infinite;
        QTest::newRow("negative") << QByteArray("-\xE2\x88\x9E") << -infinite;
        QTest::newRow("both signs") << QByteArray("\xE2\x88\x92\xE2\x88\x9E") << -infinite;
        QTest::newRow("SCPI") << QByteArray("9.9E+37") << infinite;
        QTest::newRow("SCPI, no number") << QByteArray("9.91E+37") << no_value;
        QTest::newRow("R") << QByteArray("NA") << no_value;
        QTest::newRow("word") << QByteArray("OVLD") << infinite;
    }
    void fields_that_are_numbers_in_their_own_way() {
        QFETCH(QByteArray, field);
        QFETCH(double, value);
        const auto read = parse_field(field.toStdString(), false);
        QVERIFY(read);
        QVERIFY2(*read == value || (std::isnan(*read) && std::isnan(value)),
                 qPrintable(QString("%1 instead of %2").arg(*read).arg(value)));
        for (const char* none : {"D", "1D", "DD", "1.5D+", "1-", "12:30", "\xE2\x88\x92"}) {
            QVERIFY2(!parse_field(none, false), none);
        }
    }

    void dates_and_times_of_day_data() {
        QTest::addColumn<QByteArray>("field");
        QTest::addColumn<double>("seconds");  // NaN: no time of day
        QTest::newRow("plain") << QByteArray("01:02:03.25") << 3723.25;
        QTest::newRow("comma") << QByteArray("1:02:03,5") << 3723.5;
        QTest::newRow("ISO") << QByteArray("2024-05-01T01:02:03.000001Z") << 3723.000001;
        QTest::newRow("zone") << QByteArray("2024-05-01 01:02:03+03:00") << 3723.0;
        QTest::newRow("Russian") << QByteArray("01.05.2024 01:02:03") << 3723.0;
        QTest::newRow("zone behind a blank")
            << QByteArray("2024-05-01 01:02:03.5 +03:00") << 3723.5;
        QTest::newRow("date behind") << QByteArray("01:02:03 01.05.2024") << 3723.0;
        QTest::newRow("zone and date behind")
            << QByteArray("01:02:03.25+03:00 2024-05-01") << 3723.25;
        QTest::newRow("zone apart and date behind")
            << QByteArray("01:02:03 UTC+03:00 01.05.2024") << 3723.0;
        QTest::newRow("afternoon and date behind") << QByteArray("1:02:03 PM 5/1/2024") << 46923.0;
        QTest::newRow("afternoon") << QByteArray("5/1/2024 1:02:03.5 PM") << 46923.5;
        QTest::newRow("midnight") << QByteArray("12:00:01 AM") << 1.0;
        QTest::newRow("inserted second") << QByteArray("23:59:60") << 86400.0;
        QTest::newRow("named month") << QByteArray("01-May-2024 01:02:03") << 3723.0;
        for (const char* none : {"12", "12.5", "12:30", "1:2:3:", "1.2.3", "25:61:00", "01:60:00",
                                 "01:02:61", "5/1/24 x"}) {
            QTest::newRow(none) << QByteArray(none) << no_value;
        }
    }
    void dates_and_times_of_day() {
        QFETCH(QByteArray, field);
        QFETCH(double, seconds);
        const std::string text = field.toStdString();
        const auto clock = parse_clock(text);
        const bool timed = clock && clock->timed;
        QCOMPARE(timed, !std::isnan(seconds));
        if (timed) {
            const double read = seconds_after(*clock, 0);
            VYBEG_CLOSE(read, seconds, 1e-9);
        }
    }

private:
    // Twelve rows: time in steps of 1 ms, C = 1.5 k and D = 2.5 k of a k that rises and falls.
    // `form`: a row with T, C and D for the numbers.
    static std::string rows(const char* form) {
        std::string text;
        for (int i = 0; i < 12; ++i) {
            const int k = i < 6 ? i : 12 - i;
            text += QString(form)
                        .replace('T', QString::number(i * 1e-3))
                        .replace('C', QString::number(1.5 * k))
                        .replace('D', QString::number(2.5 * k))
                        .toStdString();
        }
        return text;
    }
};

VYBEG_TEST(TestTextLayouts)

}  // namespace test_text_layouts

#include "test_text_layouts.moc"
