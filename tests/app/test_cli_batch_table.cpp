// batch: what the table is for: limits, passports, table programs, a folder that fills.
#include "tests/app/batch_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <csignal>
#include <utility>

namespace test_cli_batch_table {

using namespace vybeg::test;

class TestCliBatchTable : public QObject, private CliFolder {
    Q_OBJECT

    QByteArray table_;  // of the twelve sets

private slots:
    void initTestCase() {
        QVERIFY(make_twelve_sets(folder_.path()));
        const Outcome outcome = run("batch list.csv -o results.csv --quiet");
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
        table_ = file("results.csv");
    }

    // Guarded as in the window: the value with its expanded uncertainty.
    void a_table_of_limits_says_which_sets_pass() {
        const double tau = field_of(table_, 0, "tau_s").toDouble();
        const double u = field_of(table_, 0, "u_tau_s").toDouble();
        const auto by = [&](double deviations) {
            return QByteArray::number(tau + deviations * u, 'g', 17);
        };
        QVERIFY(put(path("one.csv"),
                    "set;file;Тип гироскопа\ns1;a.wav;M1\ns1;b.wav;M1\ngone;gone.wav;M1\n"));
        struct Case {
            QByteArray limits;
            QByteArray passed;
            QByteArray failed_by;
        };
        const std::array cases{
            Case{"parameter,least\ntau_s," + by(-2.1) + "\n", "yes", ""},
            Case{"Parameter;Least;Greatest\ntau;;" + by(2.1) + "\n", "yes", ""},
            Case{"parameter,max,comment\ntau_s," + by(-2.1) + ",as drawn\n", "no", "tau_s"},
            Case{"parameter,least\ntau_s," + by(-1.9) + "\n", "undecided", "tau_s"},
            Case{"parameter,least\ntau_s," + by(2.1) + "\n", "no", "tau_s"},
            Case{"parameter,least,gyro_type\ntau_s," + by(2.1) + ",M2\n", "", ""},
            Case{"parameter,least,gyro_type\ntau_s," + by(2.1) + ",\ntau_s,1,m1\n", "yes", ""},
            Case{"parameter,least,greatest\ntau_s," + by(2.1) + ",\nsplit_hz,,1e-9\n", "no",
                 "\"split_hz;tau_s\""}};
        for (const Case& each : cases) {
            QVERIFY(put(path("limits.csv"), each.limits));
            const Outcome outcome = run("batch one.csv -o passed.csv --limits limits.csv");
            VYBEG_EQUAL(outcome.status, 0, outcome.err);
            const QByteArray table = file("passed.csv");
            QCOMPARE(field_of(table, 0, "passed"), each.passed);
            QCOMPARE(field_of(table, 0, "failed_by"), each.failed_by);
            // Without a result; no limit is of the type.
            QCOMPARE(field_of(table, 1, "passed"),
                     QByteArray(each.passed.isEmpty() ? "" : "undecided"));
            const QByteArray count = each.passed == "no" ? "1" : "0";
            QCOMPARE(outcome.err.contains("The limits are not kept by " + count + " of "),
                     !each.passed.isEmpty());
            QCOMPARE(outcome.err.contains("Nothing is judged in 2 of 2 sets"),
                     each.passed.isEmpty());
            const QList<QByteArray> names = names_of(table);
            QCOMPARE(names.indexOf("passed"), names.indexOf("warnings") + 1);
            QCOMPARE(names.indexOf("failed_by"), names.indexOf("bias_v") - 1);
        }
        for (const auto& [limits, part] :
             {std::pair{"parameter,least\ntheta_w_rad,1\n", "\"theta_w_rad\" is none of f_mean_hz"},
              std::pair{"parameter,least\ntao_s,1\n", "(did you mean tau_s?)."},
              std::pair{"parameter,least\nsplt,1\n", "(did you mean split_hz?)."},
              std::pair{"parameter,least\ntau_s,much\n", "\"much\" is not a number"},
              std::pair{"parameter,least\ntau_s,nan\n", "\"nan\" is not a number"},
              std::pair{"parameter,least\ntau_s,\n", "least and greatest are both empty"},
              std::pair{"parameter,least,greatest\ntau_s,5,4\n", "above the greatest value"},
              std::pair{"parameter,least\ntau_s,5\ntau_s,4\n", "has a limit above already"},
              std::pair{"parameter,least,gratest\ntau_s,1,3\n",
                        "column \"gratest\": the columns are parameter, least, greatest"},
              std::pair{"parameter,gyro_type\ntau_s,M1\n", "neither least nor greatest"},
              std::pair{"name,least\ntau_s,5\n", "its columns are name, least"}}) {
            QVERIFY(put(path("limits.csv"), limits));
            const Outcome outcome = run("batch one.csv -o p.csv --limits limits.csv");
            VYBEG_EQUAL(outcome.status, 3, outcome.err);
            QVERIFY2(outcome.err.contains(part), outcome.err);
        }
    }

    void a_set_of_two_types_has_no_limits() {
        QVERIFY(
            put(path("types.csv"), "set,file,gyro_type\ns1,a.wav,M1\ns1,b.wav,M2\ns2,a.wav,M1\n"));
        QVERIFY(put(path("limits.csv"), "parameter,least\ntau_s,1\n"));
        // The others have theirs.
        const Outcome told = run("batch types.csv -o p.csv --limits limits.csv");
        QCOMPARE(told.status, 0);
        QVERIFY2(told.err.contains("the type of the gyro (M1 and M2)"), told.err);
        const QByteArray table = file("p.csv");
        QCOMPARE(field_of(table, 0, "status"), QByteArray("4"));
        QCOMPARE(field_of(table, 1, "status"), QByteArray("ok"));
        QCOMPARE(run("batch types.csv -o p.csv").status, 0);
    }

    void passports_of_a_batch_compare_with_a_later_one() {
        QVERIFY(put(path("months.csv"),
                    "set,file,gyro,temperature_c,date\ns1,a.wav,P1,22,2026-03-01\ns1,b.wav,P1,22,\n"
                    "s2,a.wav,P2,,\ns3,b.wav,P2,,\ns4,b.wav,,,\n"));
        const QStringList batch = words("batch months.csv -o m.csv --quiet");
        QCOMPARE(run(batch + words("--passports-out made")).status, 0);
        QCOMPARE(QDir(path("made")).entryList(QDir::Files),
                 (QStringList{"P1.json", "s2.json", "s3.json", "s4.json"}));
        const QJsonObject passport = object(file("made/P1.json"));
        QCOMPARE(passport["gyro"].toString(), QString("P1"));
        QCOMPARE(passport["date"].toString(), QString("2026-03-01"));
        QCOMPARE(passport["conditions"]["temperature_c"].toString(), QString("22"));
        const Outcome later = run(batch + words("--passport made"));
        VYBEG_EQUAL(later.status, 0, later.err);
        QCOMPARE(field_of(file("m.csv"), 0, "verdict"), QByteArray("unchanged"));
        QCOMPARE(run(batch + words("--passport made --passports-out made")).status, 2);
        QCOMPARE(run(batch + words("--json made --passports-out made")).status, 2);
    }

    // Significance alone calls a change that nobody minds.
    void a_practical_limit_keeps_small_changes_from_counting() {
        QVERIFY(QDir(folder_.path()).mkpath("limit"));
        for (const auto& [name, start] : {std::pair{"u.wav", "0"}, std::pair{"v.wav", "0.7854"}}) {
            QCOMPARE(run({"simulate", "--seconds", "2", "--noise", "0.001", "--tau", "4", "--split",
                          "0.02", "--theta-w", "0.2", "--two-theta-A", start, "-o", name})
                         .status,
                     0);
            QString then = name;
            QCOMPARE(
                run({"simulate", "--seconds", "2", "--noise", "0.001", "--tau", "4.1", "--split",
                     "0.02", "--theta-w", "0.2", "--two-theta-A", start, "-o", "then-" + then})
                    .status,
                0);
        }
        QCOMPARE(run("identify then-u.wav then-v.wav --passport limit/G1.json").status, 0);
        QVERIFY(put(path("limit.csv"), "set,file,gyro\ns,u.wav,G1\ns,v.wav,G1\n"));
        const auto verdict = [&](const QStringList& options) {
            const Outcome outcome =
                run("batch limit.csv -o l.csv --quiet --passport limit", options);
            return outcome.status == 0 ? field_of(file("l.csv"), 0, "verdict") : outcome.err;
        };
        QCOMPARE(verdict({}), QByteArray("changed"));
        QCOMPARE(verdict({"--limit", "tau=1%"}), QByteArray("changed"));
        QCOMPARE(verdict({"--limit", "tau=5%"}), QByteArray("unchanged"));
        QCOMPARE(verdict({"--limit", "tau_s=0.2,split=1%"}), QByteArray("unchanged"));
        QCOMPARE(verdict({"--limit", "tau=200ms"}), QByteArray("unchanged"));
        QVERIFY(verdict({"--limit", "tao=5%"}).contains("\"tao\" is none of f_mean_hz"));
        QVERIFY(verdict({"--limit", "tau_z=5%"}).contains("(did you mean tau_s?)."));
        QVERIFY(verdict({"--limit", "theta_w=5%"}).contains("theta_w is an angle"));
        QCOMPARE(verdict({"--limit", "tau=5%,theta_w=1deg"}), QByteArray("unchanged"));
        QVERIFY(verdict({"--limit", "tau"}).contains("NAME=X"));
        for (const auto& [option, value] :
             {std::pair{"--limit", "tau=5%"}, std::pair{"--f-limit", "10"}}) {
            const Outcome idle = run({"batch", "limit.csv", "-o", "l.csv", option, value});
            const QByteArray sentence =
                option + QByteArray(" has no effect: there is no --passport");
            QVERIFY2(idle.err.contains(sentence), idle.err);
        }
    }

    void a_table_for_excel_has_semicolons_and_decimal_commas() {
        QCOMPARE(run("batch list.csv -o excel.csv --excel --quiet").status, 0);
        const QByteArray excel = file("excel.csv");
        QVERIFY(excel.startsWith("\xEF\xBB\xBFset;gyro;date;files;status;"));
        QVERIFY(!excel.contains("\n#"));
        const QList<QByteArray> lines = excel.trimmed().split('\n');
        QCOMPARE(lines.size(), rows_of(table_).size() + 1);
        const QList<QByteArray> names = lines[0].mid(3).split(';');
        QCOMPARE(names.join(','), names_of(table_).join(','));
        const auto tau = names.indexOf("tau_s");
        // The files of the first set stand in quotes with a semicolon between them.
        QByteArray row = lines[1];
        row.replace("\"a.wav;b.wav\"", "files");
        QByteArray value = field_of(table_, 0, "tau_s");
        QCOMPARE(row.split(';')[tau], value.replace('.', ','));
        QVERIFY(put(path("warm.csv"), "set,file,temperature_c\nA,a.wav,20.5\nA,b.wav,21.5\n"));
        QCOMPARE(run("batch warm.csv -o excel.csv --excel --quiet").status, 0);
        QVERIFY2(file("excel.csv").contains(";\"20,5;21,5\";"), file("excel.csv"));
    }

    void the_time_of_every_command_is_told_data() {
        QTest::addColumn<QString>("arguments");
        QTest::newRow("info") << "info a.wav";
        QTest::newRow("simulate") << "simulate --seconds 1 -o timed.wav";
        QTest::newRow("batch") << "batch list.csv -o timed.csv --only s1";
        QTest::newRow("identify") << "identify a.wav b.wav -o timed.json";
    }
    void the_time_of_every_command_is_told() {
        QFETCH(QString, arguments);
        const Outcome outcome = run(arguments.split(' ') + words("--timing --quiet"));
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
        const QJsonObject told = object(outcome.err_lines().last());
        double sum = 0;
        for (const char* const key : {"read_s", "carrier_s", "estimate_s", "write_s"}) {
            VYBEG_AT_LEAST(told[QLatin1String(key)].toDouble(-1), 0);
            sum += told[QLatin1String(key)].toDouble();
        }
        VYBEG_MORE(sum, 0);
        QVERIFY(told.contains("windows") && told["threads"].toInt() > 0);
    }

    // Whole recordings and complete sets of a folder that fills; nothing waits longer than it must.
    void a_folder_that_fills_is_computed_as_it_does() {
        QVERIFY(QDir(folder_.path()).mkdir("inbox"));
        QProcess watching;
        start(watching, {"batch", "--watch", "inbox", "-o", "watched.csv", "--database",
                         "watched.db", "--quiet"});
        QVERIFY(watching.waitForStarted());
        const auto rows = [this] {
            QList<QByteArray> sets;
            const QByteArray table = file("watched.csv");
            for (int row = 0; row < rows_of(table).size(); ++row) {
                sets << field_of(table, row, "set");
            }
            return sets.join(' ');
        };
        QVERIFY(QFile::copy(path("a.wav"), path("inbox/first.wav")));
        QTRY_COMPARE_WITH_TIMEOUT(rows(), QByteArray("first.wav"), 30000);
        // A set waits for its second recording, a file for its last byte.
        QVERIFY(put(path("inbox/list.csv"), "set,file,gyro\npair,c.wav,G1\npair,d.wav,G1\n"));
        QVERIFY(QFile::copy(path("a.wav"), path("inbox/c.wav")));
        const QByteArray whole = file("b.wav");
        QFile growing(path("inbox/growing.wav"));
        QVERIFY(growing.open(QIODevice::WriteOnly));
        for (int part = 0; part < 4; ++part) {
            growing.write(whole.mid(part * whole.size() / 4, whole.size() / 4 + 1));
            growing.flush();
            QTest::qWait(300);
            QVERIFY(!rows().contains("growing"));
        }
        growing.resize(0);
        growing.seek(0);
        growing.write(whole);
        growing.close();
        QTRY_COMPARE_WITH_TIMEOUT(rows(), QByteArray("first.wav growing.wav"), 30000);
        // A list with a fault is told and waits for its correction.
        const QByteArray list = file("inbox/list.csv");
        QVERIFY(put(path("inbox/list.csv"), "set,file,from\npair,c.wav,soon\n"));
        QByteArray told;
        QTRY_VERIFY_WITH_TIMEOUT(
            (told += watching.readAllStandardError()).contains("\"soon\" is not possible"), 30000);
        QVERIFY(put(path("inbox/list.csv"), list));
        QFile second(path("inbox/d.wav"));
        QVERIFY(second.open(QIODevice::WriteOnly));
        for (int part = 0; part < 12; ++part) {
            second.write(whole.mid(part * whole.size() / 12, whole.size() / 12));
            second.flush();
            QTest::qWait(300);
            QVERIFY(!rows().contains("pair"));
        }
        second.resize(0);
        second.seek(0);
        second.write(whole);
        second.close();
        QTRY_COMPARE_WITH_TIMEOUT(rows(), QByteArray("pair first.wav growing.wav"), 30000);
        ::kill(static_cast<pid_t>(watching.processId()), SIGINT);
        QVERIFY(watching.waitForFinished());
        QCOMPARE(watching.exitCode(), 130);
        QVERIFY(watching.readAllStandardError().contains("3 of 3 sets are done"));
        QCOMPARE(watching.readAllStandardOutput().count('\n'), 3);  // each once
        const QByteArray table = file("watched.csv");
        QCOMPARE(field_of(table, 0, "status"), QByteArray("ok"));
        QCOMPARE(field_of(table, 0, "gyro"), QByteArray("G1"));
        // Again with --resume: nothing is computed twice.
        QVERIFY(QFile::copy(path("b.wav"), path("inbox/last.wav")));
        watching.start(VYBEG_CLI, {"batch", "--watch", "inbox", "-o", "watched.csv", "--database",
                                   "watched.db", "--quiet", "--resume"});
        QVERIFY(watching.waitForStarted());
        QTRY_COMPARE_WITH_TIMEOUT(rows(), QByteArray("pair first.wav growing.wav last.wav"), 30000);
        // A recording that is moved away after its measurement keeps its row.
        QVERIFY(QFile::rename(path("inbox/first.wav"), path("archived.wav")));
        QVERIFY(QFile::remove(path("inbox/d.wav")));
        QVERIFY(QFile::copy(path("b.wav"), path("inbox/z.wav")));
        QTRY_COMPARE_WITH_TIMEOUT(rows(), QByteArray("first.wav pair growing.wav last.wav z.wav"),
                                  30000);
        ::kill(static_cast<pid_t>(watching.processId()), SIGTERM);
        QVERIFY(watching.waitForFinished());
        QCOMPARE(watching.readAllStandardOutput().count('\n'), 2);
        QVERIFY(!watching.readAllStandardError().contains("cannot take"));
        // Rows of other settings are not of this table.
        watching.start(VYBEG_CLI, {"batch", "--watch", "inbox", "-o", "watched.csv", "--database",
                                   "watched.db", "--resume", "--periods", "60"});
        QVERIFY(watching.waitForStarted());
        QTRY_COMPARE_WITH_TIMEOUT(rows(), QByteArray("growing.wav last.wav z.wav"), 30000);
        ::kill(static_cast<pid_t>(watching.processId()), SIGTERM);
        QVERIFY(watching.waitForFinished());
        QVERIFY(watching.readAllStandardError().contains("cannot take"));
        QCOMPARE(run("batch --watch none -o x.csv").status, 3);
        QCOMPARE(run("batch --watch inbox -o -").status, 2);
        QCOMPARE(run("batch --watch inbox list.csv -o x.csv").status, 2);
    }

    void a_watched_folder_may_be_away_for_a_while() {
        QVERIFY(QDir(folder_.path()).mkdir("net"));
        QVERIFY(QFile::copy(path("a.wav"), path("net/one.wav")));
        QProcess watching;
        start(watching, {"batch", "--watch", "net", "-o", "net.csv", "--quiet"});
        QVERIFY(watching.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(file("net.csv").contains("one.wav"), 30000);
        QVERIFY(QFile::rename(path("net"), path("away")));
        QByteArray told;
        QTRY_VERIFY_WITH_TIMEOUT(
            (told += watching.readAllStandardError()).contains("there is no such file"), 30000);
        QVERIFY(QFile::copy(path("b.wav"), path("away/two.wav")));
        QVERIFY(QFile::rename(path("away"), path("net")));
        QTRY_VERIFY_WITH_TIMEOUT(file("net.csv").contains("two.wav"), 30000);
        ::kill(static_cast<pid_t>(watching.processId()), SIGINT);
        QVERIFY(watching.waitForFinished());
        QCOMPARE(watching.exitCode(), 130);
    }

    // The file of channel D and the table of limits are no sets.
    void a_recording_in_two_files_waits_for_both() {
        QCOMPARE(
            run("simulate --seconds 2 --noise 0.001 --tau 400 --split 1e-3 -o both.csv").status, 0);
        QByteArray c;
        QByteArray d;
        for (const QByteArray& line : file("both.csv").trimmed().split('\n')) {
            const QList<QByteArray> fields = line.split(',');
            c += fields[0] + "," + fields[1] + "\n";
            d += fields[0] + "," + fields[2] + "\n";
        }
        QVERIFY(QDir(folder_.path()).mkdir("two"));
        QVERIFY(put(path("two/limits.csv"), "parameter,least\ntau,1\n"));
        QVERIFY(put(path("two/list.csv"), "set,file,channel-d,Windw\nT,c.csv,d.csv,\n"));
        QVERIFY(put(path("two/c.csv"), c));
        QProcess watching;
        start(watching, {"batch", "--watch", "two", "-o", "two.csv", "--limits", "two/limits.csv"});
        QVERIFY(watching.waitForStarted());
        QTest::qWait(3500);
        QVERIFY(!QFile::exists(path("two.csv")));
        QVERIFY(put(path("two/d.csv"), d));
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("two.csv")), 30000);
        ::kill(static_cast<pid_t>(watching.processId()), SIGINT);
        QVERIFY(watching.waitForFinished());
        QCOMPARE(field_of(file("two.csv"), 0, "set"), QByteArray("T"));
        QCOMPARE(field_of(file("two.csv"), 0, "status"), QByteArray("ok"));
        // What is said of a list is said of one that came, once.
        QCOMPARE(watching.readAllStandardError().count("Did you mean \"window\"?"), 1);
    }

    void the_list_of_a_watched_folder_is_not_replaced() {
        QVERIFY(QDir(folder_.path()).mkdir("own"));
        const QByteArray list = "set,file\nA,a.wav\n";
        QVERIFY(put(path("own/list.csv"), list));
        QVERIFY(QFile::copy(path("a.wav"), path("own/a.wav")));
        for (const char* option : {"--json", "--passports-out"}) {
            const Outcome mixed =
                run({"batch", "--watch", "own", "-o", "own.csv", option, "./own"});
            VYBEG_EQUAL(mixed.status, 2, mixed.err);
            QVERIFY2(mixed.err.contains("recordings come to this folder"), mixed.err);
        }
        const Outcome outcome = run("batch --watch own -o own/list.csv --only A");
        QVERIFY2(outcome.err.contains("--only has no effect"), outcome.err);
        VYBEG_EQUAL(outcome.status, 2, outcome.err);
        QVERIFY2(outcome.err.contains("it is the list of the recordings"), outcome.err);
        QCOMPARE(file("own/list.csv"), list);
    }
};

VYBEG_TEST(TestCliBatchTable)

}  // namespace test_cli_batch_table

#include "test_cli_batch_table.moc"
