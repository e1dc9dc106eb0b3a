// batch --database and identify --database: several processes on one file, interruption, resuming,
// and files that cannot be a database.
#include "tests/app/batch_run.h"
#include "tests/app/sqlite_rows.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <csignal>
#include <memory>
#include <sqlite3.h>
#include <tuple>
#include <vector>

namespace test_cli_database {

using namespace vybeg::test;

namespace {

// The sets of twelve_sets that have a result.
const QStringList good_sets{"s1", "s11", "s12", "s2", "s3", "s5", "s6", "s8", "s9"};

}  // namespace

class TestCliDatabase : public QObject, private CliFolder {
    Q_OBJECT

    const QStringList work_ =
        words("batch list.csv -o results.csv --database results.db --threads 1");

    QStringList sets(const QString& database = "results.db") const {
        return rows_by_sqlite(path(database), "SELECT set_name FROM result ORDER BY set_name");
    }
    bool sound(const QString& database = "results.db") const {
        return rows_by_sqlite(path(database), "PRAGMA integrity_check") == QStringList("ok") &&
               rows_by_sqlite(path(database), "PRAGMA foreign_key_check").isEmpty() &&
               rows_by_sqlite(path(database),
                              "SELECT id FROM result WHERE id NOT IN (SELECT result FROM document)")
                   .isEmpty();
    }

private slots:
    void initTestCase() { QVERIFY(make_twelve_sets(folder_.path())); }
    void init() {
        for (const char* name :
             {"results.db", "results.db-journal", "results.csv", "results.csv.unfinished"}) {
            QFile::remove(path(name));
        }
    }

    void every_result_is_there_as_the_table_has_it() {
        const Outcome outcome = run(work_);
        QCOMPARE(outcome.status, 0);
        QCOMPARE(sets(), good_sets);
        QVERIFY(sound());
        const QStringList s1 = rows_by_sqlite(
            path("results.db"),
            "SELECT gyro, date, date_from, program, model FROM result WHERE set_name = 's1'");
        QCOMPARE(s1, QStringList("G1|2026-01-01|list|vybeg-cli " VYBEG_VERSION "|structured"));
        // tau of set s1: the table's text and the number read the same.
        const QStringList tau =
            rows_by_sqlite(path("results.db"),
                           "SELECT value FROM parameter JOIN result ON result = id "
                           "WHERE name = 'tau_s' AND set_name = 's1'");
        VYBEG_EQUAL(tau.size(), 1);
        QVERIFY(!tau[0].isEmpty());
        QCOMPARE(rows_by_sqlite(path("results.db"),
                                "SELECT file, json_extract(others, '$[0][1]') FROM recording JOIN "
                                "result ON result = id WHERE set_name = 's1' ORDER BY position"),
                 (QStringList{"a.wav|L1", "b.wav|L1"}));
        QCOMPARE(rows_by_sqlite(path("results.db"),
                                "SELECT count(*) FROM result, recording "
                                "WHERE result = id AND length(sha256) = 64"),
                 QStringList("14"));
    }

    void numbers_of_the_results_follow_the_list() {
        QStringList first;
        for (const char* jobs : {"1", "2", "7"}) {
            init();
            QCOMPARE(run(work_ + QStringList{"--jobs", jobs}).status, 0);
            const QStringList rows =
                rows_by_sqlite(path("results.db"), "SELECT id, set_name FROM result ORDER BY id");
            first = first.isEmpty() ? rows : first;
            QCOMPARE(rows, first);
        }
        QVERIFY(first.size() > 3);
    }

    // 10,000 results of four recordings in 300 MB. The documents are repeated by SQL.
    void a_result_of_four_recordings_takes_30_kB() {
        QByteArray list = "set,file\n";
        for (const char* name : {"w.wav", "x.wav", "y.wav", "z.wav"}) {
            list += QByteArray("W,") + name + "\n";
            QCOMPARE(run({"simulate", "--seconds", "4", "--noise", "0.001", "--tau", "40",
                          "--split", "0.05", "--theta-w", "0.2", "--two-theta-A",
                          QString("0.%1").arg(name[0] - 'v'), "-o", name})
                         .status,
                     0);
        }
        QVERIFY(put(path("four.csv"), list));
        QCOMPARE(run("batch four.csv -o four-results.csv --database results.db").status, 0);
        constexpr int times = 100;
        const QString results =
            "WITH RECURSIVE n(k) AS (VALUES (2) UNION ALL SELECT k + 1 FROM n "
            "WHERE k < %1) INSERT INTO %2 SELECT %3 FROM n, %2";
        for (const auto& [table, columns] :
             {std::pair{"result",
                        "k, k || key, set_name, gyro, date, date_from, program, model, warnings"},
              std::pair{"document", "k, raw_names, raw_values, raw_covariance, json"},
              std::pair{"parameter", "name, k, position, value, sd, u, reason, reason_args"}}) {
            QCOMPARE(rows_by_sqlite(path("results.db"),
                                    results.arg(times).arg(table, columns).toUtf8().constData()),
                     QStringList());
        }
        QCOMPARE(rows_by_sqlite(path("results.db"), "SELECT count(tau_s) FROM history"),
                 QStringList(QString::number(times)));
        VYBEG_AT_MOST(QFileInfo(path("results.db")).size() / times, 30000);
    }

    void a_locked_database_is_waited_for_with_a_sentence() {
        QCOMPARE(run(work_).status, 0);
        sqlite3* other = nullptr;
        QCOMPARE(sqlite3_open(path("results.db").toUtf8().constData(), &other), SQLITE_OK);
        for (const bool json : {false, true}) {
            QCOMPARE(sqlite3_exec(other, "BEGIN EXCLUSIVE", nullptr, nullptr, nullptr), SQLITE_OK);
            QProcess process;
            start(process, work_ + (json ? QStringList{"--json-log"} : QStringList{}));
            QByteArray told;
            while (!told.contains("in use") && process.state() != QProcess::NotRunning) {
                process.waitForReadyRead(1000);
                told += process.readAllStandardError();
            }
            QCOMPARE(sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr), SQLITE_OK);
            QVERIFY(process.waitForFinished(60000));
            told += process.readAllStandardError();
            QCOMPARE(process.exitCode(), 0);
            const QByteArray sentence =
                "is in use by another program. The batch waits for it, up to 60 s.";
            VYBEG_EQUAL(told.count(sentence), 1, told);
            QCOMPARE(told.contains("\"code\":\"database-waits\""), json);
        }
        sqlite3_close(other);
    }

    void the_same_again_adds_nothing() {
        QCOMPARE(run(work_).status, 0);
        QCOMPARE(run(work_).status, 0);
        QCOMPARE(sets(), good_sets);
    }

    // A slip in the list: the later set counts, whichever is computed first, and the slip is told.
    void the_same_recordings_under_two_gyros_are_told() {
        QVERIFY(put(path("slip.csv"),
                    "set,file,gyro\nfirst,a.wav,G1\nother,b.wav,G2\nlast,a.wav,G3\n"));
        const QStringList slip = words("batch slip.csv -o slip-results.csv --database results.db");
        for (const char* jobs : {"1", "3"}) {
            for (int round = 0; round < 3; ++round) {
                init();
                const Outcome outcome = run(slip + QStringList{"--jobs", jobs});
                VYBEG_EQUAL(outcome.status, 0, outcome.err);
                QCOMPARE(rows_by_sqlite(path("results.db"),
                                        "SELECT set_name, gyro FROM result ORDER BY set_name"),
                         (QStringList{"last|G3", "other|G2"}));
                QVERIFY2(outcome.err.contains(
                             "last (gyro G3) alone: first (gyro G1) has the same recordings"),
                         outcome.err);
            }
        }
        // Again: no name changes.
        QVERIFY(put(path("slip.csv"), "set,file,gyro\nother,b.wav,G2\nlast,a.wav,G3\n"));
        const Outcome same = run(slip);
        QVERIFY2(!same.err.contains("has the same recordings"), same.err);
        QVERIFY(put(path("slip.csv"), "set,file,gyro\nlast,a.wav,G4\n"));
        const Outcome renamed = run(slip);
        QVERIFY2(
            renamed.err.contains("last (gyro G4) alone: last (gyro G3) has the same recordings"),
            renamed.err);
    }

    void four_processes_at_once_lose_nothing() {
        const QStringList names{"s1", "s2", "s3", "s5", "s6", "s8", "s9", "s11", "s12"};
        for (int round = 0; round < 3; ++round) {
            init();
            std::vector<std::unique_ptr<QProcess>> processes;
            // Each process has every set, in another order: each result is written four times.
            for (int k = 0; k < 4; ++k) {
                processes.push_back(std::make_unique<QProcess>());
                QString script;
                for (int n = 0; n < names.size(); ++n) {
                    const QString& name = names[(n * (k + 1) + k) % names.size()];
                    script += QString(
                                  "'%1' batch list.csv --threads 1 --quiet --only %2 "
                                  "--database results.db -o part-%3-%2.csv || exit 9; ")
                                  .arg(VYBEG_CLI, k == 2 ? names[n] : name)
                                  .arg(k);
                }
                processes.back()->setWorkingDirectory(folder_.path());
                processes.back()->start("/bin/sh", {"-c", script});
            }
            for (const auto& process : processes) {
                QVERIFY(process->waitForFinished(120000));
                VYBEG_EQUAL(process->exitCode(), 0, process->readAllStandardError());
            }
            QCOMPARE(sets(), good_sets);
            QVERIFY(sound());
        }
    }

    void killed_at_any_moment_the_file_is_sound_and_the_rest_follows() {
        int with_some = 0;
        for (int trial = 0; trial < 8; ++trial) {
            init();
            QProcess process;
            start(process, work_);
            QVERIFY(process.waitForStarted());
            // So many results, then the next moment.
            QVERIFY(QTest::qWaitFor(
                [this, trial] {
                    const QStringList there = sets();
                    return there != QStringList("(error)") && there.size() >= 1 + trial % 7;
                },
                30000));
            process.kill();
            process.waitForFinished(20000);
            const qsizetype left = sets().size();
            QVERIFY(sound());
            with_some += left > 0 && left < good_sets.size() ? 1 : 0;
            const Outcome resumed = run(work_ + QStringList{"--resume"});
            VYBEG_EQUAL(resumed.status, 0, resumed.err);
            QCOMPARE(sets(), good_sets);
            QVERIFY(sound());
        }
        VYBEG_AT_LEAST(with_some, 2, "too few kills met a database with some of its results");
    }

    void resuming_without_the_database_fills_a_new_one() {
        QProcess process;
        start(process, work_);
        QVERIFY(QTest::qWaitFor([this] { return sets().contains("s1"); }, 30000));
        process.kill();
        process.waitForFinished(20000);
        QFile::remove(path("results.db"));
        QFile::remove(path("results.db-journal"));
        QCOMPARE(run(work_ + QStringList{"--resume"}).status, 0);
        QCOMPARE(sets(), good_sets);
    }

    void a_file_that_may_not_grow_leaves_whole_results() {
        QCOMPARE(run(work_).status, 0);
        const qint64 whole = QFileInfo(path("results.db")).size();
        for (int k = 0; k < 8; ++k) {
            init();
            const Outcome outcome = run_here(VYBEG_CLI, work_, limit(RLIMIT_FSIZE, whole * k / 8));
            QCOMPARE(outcome.status, 5);
            // SQLite does not tell the limit of a size from other failures.
            QVERIFY2(outcome.err.contains("results.db cannot be written: "), outcome.err);
            QVERIFY(QFileInfo(path("results.db")).size() == 0 || sound());
        }
    }

    // The same recordings and settings have the same result, whichever command computes it.
    void identify_stores_what_batch_stores() {
        QCOMPARE(run(work_ + words("--only s1")).status, 0);
        const auto stored = [this] {
            return rows_by_sqlite(
                path("results.db"),
                "SELECT key, r.set_name, r.gyro, r.date, tau_s, u_tau_s, file, "
                "json_extract(others, '$[0][1]') FROM result r JOIN history h ON id = h.result "
                "JOIN recording c ON id = c.result ORDER BY position");
        };
        const QStringList by_batch = stored();
        QCOMPARE(by_batch.size(), 2);
        QFile::remove(path("results.db"));
        const Outcome outcome =
            run("identify --list list.csv --set s1 -o s1.json --database results.db");
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
        QCOMPARE(stored(), by_batch);
        QVERIFY(sound());
        // The files of the command line have their first one as name, and no gyro.
        const Outcome plain = run("identify a.wav b.wav --database results.db");
        VYBEG_EQUAL(plain.status, 0, plain.err);
        QVERIFY2(
            plain.err.contains("the result of a.wav alone: s1 (gyro G1) has the same recordings"),
            plain.err);
        QCOMPARE(rows_by_sqlite(path("results.db"), "SELECT set_name, gyro FROM result"),
                 QStringList("a.wav|"));
    }

    void identify_refuses_what_cannot_be_a_database() {
        QVERIFY(put(path("list2.db"), twelve_sets));
        for (const auto& [file, status, sentence] :
             {std::tuple{"list2.db", 5, "it is another kind of file"},
              std::tuple{"-", 2, "it must be a file"},
              std::tuple{"a.wav", 2, "it is one of the recordings"},
              std::tuple{"s1.json", 2, "the result goes there already"},
              std::tuple{"none/results.db", 5, "No such file or directory"}}) {
            QFile::remove(path("s1.json"));
            const Outcome outcome = run({"identify", "a.wav", "-o", "s1.json", "--database", file});
            QCOMPARE(outcome.status, status);
            QVERIFY2(outcome.err.contains(sentence), outcome.err);
            QVERIFY(!QFile::exists(path("s1.json")));
        }
        QCOMPARE(file("list2.db"), twelve_sets);
    }

    void what_cannot_be_a_database_is_told_before_the_work_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("status");
        QTest::addColumn<QByteArray>("sentence");
        QTest::newRow("text") << "list2.db" << 5 << QByteArray("it is another kind of file");
        QTest::newRow("folder") << "." << 5 << QByteArray("it is a folder");
        QTest::newRow("no folder")
            << "none/results.db" << 5 << QByteArray("No such file or directory");
        QTest::newRow("device") << "/dev/null" << 5 << QByteArray("it is no regular file");
        QTest::newRow("standard output") << "-" << 2 << QByteArray("it must be a file");
        QTest::newRow("recording") << "a.wav" << 2 << QByteArray("it is one of the recordings");
        QTest::newRow("list") << "./list.csv" << 2 << QByteArray("it is the list");
        QTest::newRow("table") << "./results.csv" << 2
                               << QByteArray("the table goes there already");
        QTest::newRow("journal") << "results.csv.unfinished" << 2
                                 << QByteArray("the table goes there already");
    }

    void what_cannot_be_a_database_is_told_before_the_work() {
        QFETCH(QString, file);
        QFETCH(int, status);
        QFETCH(QByteArray, sentence);
        QVERIFY(put(path("list2.db"), twelve_sets));
        const QByteArray list = content(path("list.csv"));
        QStringList line = work_;
        line[5] = file;
        const Outcome outcome = run(line);
        QCOMPARE(outcome.status, status);
        QVERIFY2(outcome.err.contains(sentence), outcome.err);
        QVERIFY(!QFile::exists(path("results.csv")));
        QCOMPARE(content(path("list.csv")), list);
        QCOMPARE(content(path("list2.db")), twelve_sets);
    }

    void a_database_in_the_folder_of_recordings_is_no_recording() {
        QDir(folder_.path()).mkdir("runs");
        QVERIFY(QFile::copy(path("a.wav"), path("runs/a.wav")) ||
                QFile::exists(path("runs/a.wav")));
        const QStringList line = words("batch runs -o t.csv --database runs/r.db");
        QCOMPARE(run(line).status, 0);
        QCOMPARE(run(line).status, 0);
        QCOMPARE(sets("runs/r.db"), QStringList("a.wav"));
        QCOMPARE(rows_of(file("t.csv")).size(), 1);
    }
};

VYBEG_TEST(TestCliDatabase, unsanitized)

}  // namespace test_cli_database

#include "test_cli_database.moc"
