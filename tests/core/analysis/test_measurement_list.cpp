// Measurement lists: what a row says of its recording, and where a row is wrong.
#include "core/analysis/list_fields.h"
#include "core/analysis/measurement_list.h"
#include "core/analysis/setting_table.h"
#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/recording/samples/open_table.h"
#include "tests/needed.h"
#include "tests/test_registry.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>
#include <numbers>

namespace test_measurement_list {

using namespace vybeg;

namespace {

// Columns of a list that are options, with a value each.
const std::vector<std::pair<QByteArray, QByteArray>> every_option{{"algorithm", "in-phase"},
                                                                  {"hop", "10"},
                                                                  {"initial", "\"1,0,0.3,0,5300\""},
                                                                  {"start", "previous"},
                                                                  {"model", "free"},
                                                                  {"columns", "\"E,R,S,Q\""},
                                                                  {"angle-unit", "deg"},
                                                                  {"phasors", "none"},
                                                                  {"f-ref", "none"},
                                                                  {"y-sign", "none"},
                                                                  {"amplitude", "none"},
                                                                  {"lock-in", "none"},
                                                                  {"window", "500"},
                                                                  {"snap", "yes"},
                                                                  {"f0", "5300"},
                                                                  {"from", "1"},
                                                                  {"to", "2"},
                                                                  {"band", "\"5000,5600\""},
                                                                  {"filter", "\"5000,5600\""},
                                                                  {"kappa", "1.1"},
                                                                  {"offset", "auto"},
                                                                  {"delay", "1e-6"},
                                                                  {"angle-zero", "5"},
                                                                  {"repair-lost", "yes"},
                                                                  {"threads", "1"},
                                                                  {"tolerance", "skew=1"},
                                                                  {"rate", "1000"},
                                                                  {"channels", "\"2,1\""},
                                                                  {"variables", "\"C,D\""},
                                                                  {"raw", "f64:be"},
                                                                  {"raw-channels", "3"},
                                                                  {"skip", "8"},
                                                                  {"scale", "2"},
                                                                  {"unit", "V"}};

}  // namespace

class TestMeasurementList : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::filesystem::path write(const QByteArray& text) const {
        const std::filesystem::path path = folder_.filePath("list.csv").toStdString();
        std::ofstream(path, std::ios::binary).write(text.data(), text.size());
        return path;
    }

    MeasurementList list(const QByteArray& text, const OpenOptions& open = {},
                         const IdentifySettings& settings = {}) const {
        return test::needed(read_measurement_list(write(text), open, settings));
    }

private slots:
    void a_row_holds_a_recording_its_options_and_conditions() {
        const MeasurementList read = list(
            "file,set,channels,from,tolerance,gyro,date,bias_v,temperature_c,exchanged,operator,"
            "comment,Batch\n"
            "runs/a.wav,A,\"2,1\",0.5,\"skew=0.1deg,delay=10ns\",G7,2026-03-31T14:05,100,22.5,yes,"
            "Иванов,first,L1\n");
        QCOMPARE(read.sets.size(), std::size_t{1});
        const MeasurementSet& set = read.sets[0];
        QCOMPARE(set.name, "A");
        QCOMPARE(set.settings.signal.from_s, std::optional(0.5));
        QVERIFY(set.settings.of_recordings.empty());
        QCOMPARE(set.settings.tolerance[skew_error].value_or(-1), 0.1);
        QCOMPARE(set.settings.tolerance[delay_error].value_or(-1), 1e-8);
        const RecordingRef& recording = set.recordings[0];
        QCOMPARE(recording.file, "runs/a.wav");
        QCOMPARE(QString::fromStdString(recording.path.string()), folder_.filePath("runs/a.wav"));
        QCOMPARE(recording.open.channel_c, 2);
        QCOMPARE(recording.open.channel_d, 1);
        const Conditions& told = recording.conditions;
        QCOMPARE(told.gyro, "G7");
        QCOMPARE(told.date, "2026-03-31T14:05");
        QCOMPARE(told.bias_v, std::optional(100.0));
        QCOMPARE(told.temperature_c, std::optional(22.5));
        QVERIFY(told.exchanged);
        QCOMPARE(told.operator_name, "Иванов");
        QCOMPARE(told.comment, "first");
        QVERIFY(read.other_columns == std::vector<std::string>{"Batch"});
        QCOMPARE(recording.others.size(), std::size_t{1});
        QCOMPARE(recording.others[0].first, "Batch");
        QCOMPARE(recording.others[0].second, "L1");
    }

    void a_list_is_told_from_a_recording_by_its_first_row() {
        const auto is_list = [this](const QString& name, const QByteArray& text) {
            const std::filesystem::path path = folder_.filePath(name).toStdString();
            std::ofstream(path, std::ios::binary).write(text.data(), text.size());
            return is_measurement_list(path);
        };
        QVERIFY(is_list("a.csv", "file\na.wav\n"));
        QVERIFY(is_list("b.CSV", "\xEF\xBB\xBFset; file ;date\n"));
        QVERIFY(is_list("c.txt", "\"set, of a gyro\",\"file\"\n"));
        // Faults of a list are for read_measurement_list().
        QVERIFY(is_list("d.csv", "file,set,set\na.wav\n"));
        QVERIFY(!is_list("e.csv", "t,C,D\n0,1,2\n"));
        QVERIFY(!is_list("f.csv", "0.1 0.2\nfile,set\n"));
        QVERIFY(!is_list("g.csv", ""));
        QVERIFY(!is_list("h.wav", "file,set\na.wav,A\n"));
        QVERIFY(!is_measurement_list(folder_.filePath("none.csv").toStdString()));
        QVERIFY(!is_measurement_list(folder_.path().toStdString()));
    }

    void rows_of_one_name_are_one_set_in_order() {
        const MeasurementList read =
            list("set,file\nB,1.wav\nA,2.wav\nB,3.wav\n,4.wav\n,4.wav\nA,5.wav\n");
        std::vector<std::string> told;
        for (const MeasurementSet& set : read.sets) {
            std::string files = set.name + ":";
            for (const RecordingRef& recording : set.recordings) {
                files += " " + recording.file;
            }
            told.push_back(files);
        }
        QVERIFY((told == std::vector<std::string>{"B: 1.wav 3.wav", "A: 2.wav 5.wav",
                                                  "4.wav: 4.wav", "4.wav (6): 4.wav"}));
    }

    void without_the_column_every_row_is_a_set() {
        const MeasurementList read = list("file\na.wav\nsub/b.wav\n");
        QCOMPARE(read.sets.size(), std::size_t{2});
        QCOMPARE(read.sets[1].name, "sub/b.wav");
    }

    void a_comma_is_a_decimal_sign() {
        const MeasurementList read = list(
            "file;from;filter;rate;channels;offset;bias_v\n"
            "a.wav;0,25;\"5000,5;5600\";33333,3;1,2;1,2;99,5\n"
            "b.wav;0.25;5000.5,5600;33333.3;1,2;\"1;2\";99.5\n");
        for (const MeasurementSet& set : read.sets) {
            QCOMPARE(set.settings.signal.from_s, std::optional(0.25));
            QVERIFY(set.settings.signal.filter == std::optional(Band{5000.5, 5600}));
            QCOMPARE(set.settings.signal.calibration.offset_d, 2.0);
            QCOMPARE(set.recordings[0].open.rate_hz, std::optional(33333.3));
            QCOMPARE(set.recordings[0].open.channel_d, 2);
            QCOMPARE(set.recordings[0].conditions.bias_v, std::optional(99.5));
        }
    }

    void every_option_of_analyze_and_identify_is_a_column() {
        QByteArray names = "file";
        QByteArray row = "a.wav";
        for (const auto& [name, value] : every_option) {
            names += "," + name;
            row += "," + value;
        }
        const MeasurementList read = list(names + "\n" + row + "\n");
        QVERIFY(read.other_columns.empty());
        const MeasurementSet& set = read.sets[0];
        QVERIFY(set.settings.model == FitOptions::Model::free);
        QCOMPARE(set.settings.windows.window, std::optional(std::int64_t{500}));
        QVERIFY(set.settings.signal.repair_lost);
        QCOMPARE(set.settings.signal.calibration.kappa, 1.1);
        QCOMPARE(set.recordings[0].open.raw->channels, 3);
        QCOMPARE(set.recordings[0].open.scale, 2.0);
        QVERIFY(set.recordings[0].open.raw->big_endian);
        QCOMPARE(set.recordings[0].open.unit, "V");
        // What an identification does not use is said once.
        QStringList idle;
        for (const Diagnostic& warning : read.warnings) {
            QVERIFY(warning.kind == DiagnosticKind::option_without_effect);
            idle << QString::fromStdString(english(warning.args[0]));
        }
        QCOMPARE(idle, (QStringList{"--algorithm", "--hop", "--initial", "--start"}));

        const MeasurementList text = list(
            "file,delimiter,decimal,skip-lines,time-column,time-unit,"
            "periods\na.csv,tab,comma,2,none,ms,80.5\n");
        const TextChoice& choice = *text.sets[0].recordings[0].open.text;
        QVERIFY(choice.delimiter == std::optional('\t') && choice.decimal_comma == true);
        QCOMPARE(choice.lines_to_skip, std::optional(std::int64_t{2}));
        QCOMPARE(choice.time_column, std::optional(0));
        QCOMPARE(text.sets[0].settings.windows.periods, std::optional(80.5));
    }

    void columns_say_what_logs_are() {
        const MeasurementList read = list(
            "file;set;columns;angle_unit;phasors;F-ref;y-sign;Amplitude;lock-in\n"
            "a.csv;A;Xc=3,Yc=4,Xd=5,Yd=6;;common;5300,5;-;rms;\"4;20,5\"\n"
            "b.csv;B;a,b,theta;deg;;;;;\n"
            "c.csv;A;;;;;;;\n"
            "d.wav;C;;;;;;;\n");
        QVERIFY(read.other_columns.empty());
        QVERIFY(read.warnings.empty());
        QCOMPARE(read.sets.size(), std::size_t{3});
        const LogChoice& a = read.sets[0].settings.logs;
        QCOMPARE(a.names, std::string("Xc=3,Yc=4,Xd=5,Yd=6"));
        QVERIFY((a.phasors ==
                 PhasorChoice{PhasorFrame::common, 5300.5, -1, std::numbers::sqrt2, {4, 20.5}}));
        QCOMPARE(read.sets[0].recordings.size(), std::size_t{2});
        QVERIFY(read.sets[0].settings.of_recordings.empty());
        const LogChoice& b = read.sets[1].settings.logs;
        QVERIFY(b.without_phase());
        QCOMPARE(b.rad_per_angle_unit, std::numbers::pi / 180);
        QVERIFY(read.sets[2].settings.logs == LogChoice{});
    }

    void a_column_that_resembles_an_option_is_kept_and_warned_of() {
        const std::pair<const char*, const char*> pairs[]{
            {"filtre", "filter"}, {"chanels", "channels"},     {"Kapa", "kappa"},
            {"dealy", "delay"},   {"windw", "window"},         {"temprature_c", "temperature_c"},
            {"files", "file"},    {"angel zero", "angle-zero"}};
        for (const auto& [name, option] : pairs) {
            const MeasurementList read = list(QByteArray("file,") + name + "\na.wav,1\n");
            QCOMPARE(read.other_columns, (std::vector<std::string>{name}));
            QCOMPARE(read.warnings.size(), 1U);
            QVERIFY(read.warnings[0].kind == DiagnosticKind::column_like_option);
            QCOMPARE(english(read.warnings[0].args[1]), std::string(option));
            // Said without being asked for.
            QVERIFY(severity(read.warnings[0].kind) == Severity::warning);
        }
        for (const char* const name : {"lot", "note", "to2", "serial", "offsets2", "tau"}) {
            QVERIFY2(list(QByteArray("file,") + name + "\na.wav,1\n").warnings.empty(), name);
        }
    }

    void a_row_goes_before_the_command_line_which_goes_before_nothing() {
        IdentifySettings line;
        line.signal.from_s = 1;
        line.signal.to_s = 9;
        line.windows.periods = 80;
        OpenOptions open;
        open.rate_hz = 100;
        const MeasurementList read =
            list("file,from,rate,window\na.wav,2,200,500\nb.wav,,,\n", open, line);
        const MeasurementSet& own = read.sets[0];
        QCOMPARE(own.settings.signal.from_s, std::optional(2.0));
        QCOMPARE(own.settings.signal.to_s, std::optional(9.0));
        QCOMPARE(own.recordings[0].open.rate_hz, std::optional(200.0));
        QVERIFY(!own.settings.windows.periods);
        QCOMPARE(own.settings.windows.window, std::optional(std::int64_t{500}));
        const MeasurementSet& usual = read.sets[1];
        QCOMPARE(usual.settings.signal.from_s, std::optional(1.0));
        QCOMPARE(usual.recordings[0].open.rate_hz, std::optional(100.0));
        QCOMPARE(usual.settings.windows.periods, std::optional(80.0));
    }

    void recordings_of_a_set_may_have_their_own_range() {
        const MeasurementList read =
            list("set,file,from,kappa\nA,a.wav,1,\nA,b.wav,2,1.5\nA,c.wav,,\n");
        const IdentifySettings& settings = read.sets[0].settings;
        QCOMPARE(settings.of_recordings.size(), std::size_t{3});
        QCOMPARE(settings.signal_of(0).from_s, std::optional(1.0));
        QCOMPARE(settings.signal_of(1).from_s, std::optional(2.0));
        QCOMPARE(settings.signal_of(2).from_s, std::optional<double>());
        for (std::size_t k = 0; k < 3; ++k) {  // the gain ratio is that of the set
            QCOMPARE(settings.signal_of(k).calibration.kappa, 1.5);
        }
        QCOMPARE(settings.signal.calibration.kappa, 1.5);
        for (const auto& [name, value] : settings_list(settings)) {
            if (name == "from") {
                QCOMPARE(value, "1; 2; none");
            }
            if (name == "kappa") {
                QCOMPARE(value, "1.5");
            }
        }
    }

    void a_fault_names_its_line_and_column_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const QByteArray& text, const QString& sentence) {
            QTest::newRow(QByteArray(text).replace('\n', " / ")) << text << sentence;
        };
        row("file,from\na.wav,x\n",
            ", line 2, column \"from\": \"x\" is not possible: it must be a number, with a point, "
            "in s or with its unit behind it.");
        row("file,set,filter\na.wav,A,\nb.wav,A,\"6000,5000\"\n",
            ", line 3, column \"filter\": \"6000\" is not possible: a band needs a low edge of at "
            "least 0 Hz and a higher edge.");
        row("file,channels\na.wav,\"2,2\"\n",
            ", line 2, column \"channels\": \"2,2\" is not possible: C and D must be two "
            "channels.");
        row("file,kappa\na.wav,0\n",
            ", line 2, column \"kappa\": \"0\" is not possible: it must lie between 1e-6 and 1e6.");
        row("file,skip\na.wav,4\n",
            ", line 2, column \"skip\": \"4\" is not possible: it needs --raw.");
        row("file,algorithm\na.wav,best\n",
            ", line 2, column \"algorithm\": \"best\" is not possible: it is in-phase, "
            "phase-shift, moving-axes, demodulation, conjugate-gradient or maximum-likelihood.");
        row("file,window,periods\na.wav,60,5\n",
            ", line 2, column \"periods\": the window is given in samples, too.");
        row("file,set,model\na.wav,A,free\nb.wav,A,\nc.wav,A,auto\n",
            ", line 4, column \"model\": \"auto\" differs from \"free\" in line 2, and one value "
            "holds for all recordings of a set: tell the same, or give the row a set of its own.");
        row("file,date\na.wav,31.02.2026\n",
            ", line 2, column \"date\": \"31.02.2026\" is no date as in 2026-03-31 or 31.03.2026, "
            "with or without a time as in T14:05.");
        row("file,bias_v\na.wav,100 kV\n",
            ", line 2, column \"bias_v\": \"100 kV\" is not a number.");
        row("file,exchanged\na.wav,2\n",
            ", line 2, column \"exchanged\": \"2\" is neither yes nor no.");
        row("file,set\n,A\n", ", line 2, column \"file\": no file is named.");
        row("file,set\n", ", line 1, column \"file\": no row names a recording below it.");
        row("file,--from\na.wav,1\n", ", line 1, column \"--from\": an option has no dashes here.");
    }

    void dates_and_answers_are_those_of_tables_data() {
        QTest::addColumn<QByteArray>("date");
        QTest::addColumn<QString>("iso");
        QTest::addColumn<QByteArray>("answer");
        QTest::addColumn<bool>("yes");
        QTest::newRow("ISO") << QByteArray("2026-10-16T14:05") << "2026-10-16T14:05"
                             << QByteArray("yes") << true;
        QTest::newRow("date") << QByteArray("16.10.2026") << "2026-10-16" << QByteArray("да")
                              << true;
        QTest::newRow("time") << QByteArray("16.10.2026 14:05") << "2026-10-16T14:05"
                              << QByteArray("Нет") << false;
        QTest::newRow("hour of one digit")
            << QByteArray("16.10.2026 9:05") << "2026-10-16T09:05" << QByteArray("ИСТИНА") << true;
        QTest::newRow("ISO with a blank")
            << QByteArray("2026-10-16 14:05") << "2026-10-16T14:05" << QByteArray("FALSE") << false;
        QTest::newRow("seconds") << QByteArray("01.02.2026 04:05:06") << "2026-02-01T04:05:06"
                                 << QByteArray("YES") << true;
    }

    void dates_and_answers_are_those_of_tables() {
        QFETCH(QByteArray, date);
        QFETCH(QString, iso);
        QFETCH(QByteArray, answer);
        QFETCH(bool, yes);
        const auto read = read_measurement_list(
            write("file,date,exchanged\na.wav," + date + "," + answer + "\n"), {}, {});
        QVERIFY(read);
        const Conditions& told = read->sets[0].recordings[0].conditions;
        QCOMPARE(QString::fromStdString(told.date), iso);
        QCOMPARE(told.exchanged, yes);
    }

    void columns_have_russian_names_and_any_letters_data() {
        QTest::addColumn<QByteArray>("names");
        QTest::newRow("English") << QByteArray("file,set,gyro,temperature_c,bias_v,exchanged,from");
        QTest::newRow("capitals") << QByteArray(
            "FILE,Set,Gyro,Temperature_C,Bias_V,Exchanged,From");
        QTest::newRow("blanks") << QByteArray("File,Set,Gyro,Temperature C,bias v,exchanged,from");
        QTest::newRow("English with units")
            << QByteArray("file,set,gyro,\"Temperature, °C\",Bias (V),exchanged,from");
        QTest::newRow("a unit behind a blank")
            << QByteArray("file,set,gyro,Temperature °C,Bias voltage,exchanged,from");
        QTest::newRow("below empty lines")
            << QByteArray("\n# March\n \nfile,set,gyro,temperature_c,bias_v,exchanged,from");
        QTest::newRow("Russian") << QByteArray(
            "файл,набор,гироскоп,температура,напряжение смещения,перестановка,от");
        QTest::newRow("Russian with units") << QByteArray(
            "Файл,НАБОР,Прибор,\"Температура, °C\",\"Напряжение смещения, В\",Перестановка "
            "усилителей,\"От, с\"");
        QTest::newRow("Russian with underscores") << QByteArray(
            "файл,набор,гироскоп,температура_с,напряжение_смещения_в,перестановка,от");
        QTest::newRow("Windows-1251") << QByteArray(
            "\xF4\xE0\xE9\xEB,\xED\xE0\xE1\xEE\xF0,gyro,temperature_c,bias_v,exchanged,from");
    }
    void columns_have_russian_names_and_any_letters() {
        QFETCH(QByteArray, names);
        const MeasurementList read = list(names + ",Партия\na.wav,A,G7,22.5,100,yes,0.5,L1\n");
        QCOMPARE(read.sets[0].name, "A");
        QCOMPARE(read.sets[0].settings.signal.from_s, std::optional(0.5));
        const Conditions& told = read.sets[0].recordings[0].conditions;
        QCOMPARE(told.gyro, "G7");
        QCOMPARE(told.temperature_c, std::optional(22.5));
        QCOMPARE(told.bias_v, std::optional(100.0));
        QVERIFY(told.exchanged);
        QVERIFY(read.warnings.empty());
        QCOMPARE(read.other_columns.size(), std::size_t{1});
        QCOMPARE(read.sets[0].recordings[0].others[0].second, "L1");
    }

    void numbers_have_the_signs_of_table_programs() {
        const auto temperature = [this](const char* number) {
            return list("file;temperature_c\na.wav;" + QByteArray(number) + "\n")
                .sets[0]
                .recordings[0]
                .conditions.temperature_c;
        };
        for (const char* number : {"-102.5", "\u2212102,5", "-102,5 °C", "\u2212102.5°C"}) {
            QCOMPARE(temperature(number), std::optional(-102.5));
        }
        QCOMPARE(temperature("1\u00A0022,5"), std::optional(1022.5));
    }

    void options_take_the_answers_and_blanks_of_table_programs() {
        const MeasurementList read =
            list("file;snap;filter\na.wav;да;2900, 3100\nb.wav;FALSE;\"2900,5; 3100\"\n");
        QVERIFY(read.sets[0].settings.windows.snap);
        QVERIFY(!read.sets[1].settings.windows.snap);
        QCOMPARE(read.sets[0].settings.signal.filter->low_hz, 2900.0);
        QCOMPARE(read.sets[1].settings.signal.filter->low_hz, 2900.5);
        QCOMPARE(read.sets[1].settings.signal.filter->high_hz, 3100.0);
    }

    void a_workbook_is_no_list_and_named() {
        for (const QByteArray& start : {QByteArray("PK\3\4"), QByteArray("\xD0\xCF\x11\xE0")}) {
            const auto read = read_measurement_list(write(start + QByteArray(500, '\xB4')), {}, {});
            QVERIFY(!read);
            const std::string text = english(read.error());
            QVERIFY2(text.ends_with("it is a workbook; save the sheet as CSV."), text.c_str());
        }
    }

    void a_path_of_windows_names_a_file_of_the_list() {
        QVERIFY(QDir(folder_.path()).mkpath("runs"));
        std::ofstream(folder_.filePath("runs/w.wav").toStdString()) << "x";
        const MeasurementList read =
            list("file,channel-d,join\nruns\\w.wav,runs\\w.wav,\nruns/w.wav,,runs\\w.wav\n");
        QVERIFY(std::filesystem::exists(read.sets[0].recordings[0].path));
        for (const MeasurementSet& set : read.sets) {
            const auto parts = further_files(set.recordings[0].open);
            QCOMPARE(parts.size(), std::size_t{1});
            QVERIFY(std::filesystem::exists(parts[0]));
        }
    }

    void a_list_without_files_names_its_columns() {
        const auto read = read_measurement_list(write("# March\nFiles;Set\na.wav;A\n"), {}, {});
        QVERIFY(!read);
        const QString text = QString::fromStdString(english(read.error()));
        QVERIFY2(text.contains("line 2") && text.contains("its columns are Files, set"),
                 qPrintable(text));
    }

    void a_field_that_a_table_program_runs_is_told() {
        const auto read =
            read_measurement_list(write("file,comment,bias_v,gyro\na.wav,=1+1,-3,@G\nb.wav,-cmd|x,"
                                        "\"-3,5\",@G\nc.wav,+5,,@G\n"),
                                  {}, {});
        QVERIFY(read);
        QStringList told;
        for (const Diagnostic& warning : read->warnings) {
            QVERIFY(warning.kind == DiagnosticKind::formula_in_list);
            told << QString::fromStdString(english(warning.args[0]) + ": " +
                                           english(warning.args[1]));
        }
        QCOMPARE(told, (QStringList{"=1+1: line 2 of the list, column \"comment\"",
                                    "@G: line 2 of the list, column \"gyro\"",
                                    "-cmd|x: line 3 of the list, column \"comment\"",
                                    "@G: line 3 of the list, column \"gyro\"",
                                    "@G: line 4 of the list, column \"gyro\""}));
        // The name of a file is that of its set in the table.
        QVERIFY(QDir(folder_.path()).mkpath("named"));
        for (const char* name : {"=1+1.wav", "plain.wav", "-5.wav"}) {
            std::ofstream(folder_.filePath(QString("named/") + name).toStdString()) << "x";
        }
        const auto of_folder = list_of_folder(folder_.filePath("named").toStdString(), {}, {},
                                              [](const auto&) { return false; });
        QVERIFY(of_folder);
        QStringList named;
        for (const Diagnostic& warning : of_folder->warnings) {
            named << QString::fromStdString(english(warning.args[0]) + ": " +
                                            english(warning.args[1]));
        }
        QCOMPARE(named,
                 (QStringList{"-5.wav: a file of the folder", "=1+1.wav: a file of the folder"}));
    }

    void a_fault_names_its_line_and_column() {
        QFETCH(QByteArray, text);
        QFETCH(QString, sentence);
        const std::filesystem::path path = write(text);
        const auto read = read_measurement_list(path, {}, {});
        QVERIFY(!read);
        QVERIFY(read.error().code == ErrorCode::list_invalid);
        QCOMPARE(exit_status(read.error().code), 3);
        QCOMPARE(QString::fromStdString(english(read.error())),
                 QString::fromStdString(path.string()) + sentence);
    }

    void conditions_that_the_fit_does_not_know_are_refused_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("part");
        const auto row = [](const QByteArray& text, const QString& part) {
            QTest::newRow(QByteArray(text).replace('\n', " / ")) << text << part;
        };
        row("set,file,bias_v\nA,a.wav,100\nA,b.wav,100\n", "");
        row("set,file,bias_v\nA,a.wav,100\nA,b.wav,\n", "");
        row("set,file,bias_v\nA,a.wav,100\nA,b.wav,120\n",
            "A: the recordings differ in the bias voltage (100 V and 120 V)");
        row("set,file,gyro\nA,a.wav,\nA,b.wav,G1\nA,c.wav,G2\n", "in the gyro (G1 and G2)");
        row("set,file,exchanged\nA,a.wav,\nA,b.wav,yes\n",
            "in the exchange of the amplifiers (no and yes)");
        row("set,file,temperature_c,date\nA,a.wav,22,2026-01-01\nA,b.wav,23,2026-01-02\n", "");
    }

    void conditions_that_the_fit_does_not_know_are_refused() {
        QFETCH(QByteArray, text);
        QFETCH(QString, part);
        const Status alike = check_conditions(list(text).sets[0]);
        QCOMPARE(static_cast<bool>(alike), part.isEmpty());
        if (!alike) {
            QCOMPARE(exit_status(alike.error().code), 4);
            const QString sentence = QString::fromStdString(english(alike.error()));
            QVERIFY2(sentence.contains(part), qPrintable(sentence));
        }
    }

    void dates_are_those_of_iso_8601() {
        for (const char* date :
             {"2026-03-31", "2024-02-29", "2026-03-31T14:05", "2026-03-31 14:05:59",
              "2026-03-31T14:05:30.25Z", "2026-03-31T14:05+03:00"}) {
            QVERIFY2(is_iso_date(date), date);
        }
        for (const char* date : {"2026-02-29", "2026-13-01", "2026-3-31", "31.03.2026", "2026-03",
                                 "2026-03-31T", "2026-03-31T25:00", "2026-03-31T14:05+3",
                                 "2026-03-31T14:05:30.", "2026-03-31Z", "2026-03-31T14:05 x"}) {
            QVERIFY2(!is_iso_date(date), date);
        }
    }

    void a_folder_is_a_list_of_its_files() {
        const QTemporaryDir folder;
        QDir(folder.path()).mkdir("sub");
        for (const char* name : {"b.wav", "a.wav", ".hidden.wav", "results.csv", "sub/c.wav"}) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        OpenOptions open;
        open.rate_hz = 100;
        const auto read = list_of_folder(
            folder.path().toStdString(), open, {},
            [](const std::filesystem::path& path) { return path.filename() == "results.csv"; });
        QVERIFY(read);
        QCOMPARE(read->sets.size(), std::size_t{2});
        QCOMPARE(read->sets[0].name, "a.wav");
        QCOMPARE(read->sets[1].name, "b.wav");
        QCOMPARE(read->sets[0].recordings[0].open.rate_hz, std::optional(100.0));
    }
};

VYBEG_TEST(TestMeasurementList)

}  // namespace test_measurement_list

#include "test_measurement_list.moc"
