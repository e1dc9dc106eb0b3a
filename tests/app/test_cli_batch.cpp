// batch: a measurement list becomes a table, a row for each set, whatever becomes of the set.
#include "tests/app/batch_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <utility>

namespace test_cli_batch {

using namespace vybeg::test;

class TestCliBatch : public QObject, private CliFolder {
    Q_OBJECT

    QByteArray table_;  // of the twelve sets

private slots:
    void initTestCase() {
        QVERIFY(make_twelve_sets(folder_.path()));
        const Outcome outcome = run("batch list.csv -o results.csv --json json");
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
        table_ = file("results.csv");
    }

    void a_row_for_each_set_in_the_order_of_the_list() {
        QCOMPARE(
            names_of(table_).join(','),
            QByteArray("set,gyro,date,files,status,message,model,f_mean_hz,sd_f_mean_hz,"
                       "split_hz,sd_split_hz,theta_w_rad,sd_theta_w_rad,tau_s,sd_tau_s,q,sd_q,"
                       "damping_anisotropy_per_s,sd_damping_anisotropy_per_s,theta_tau_rad,"
                       "sd_theta_tau_rad,angle_rate_rad_s,sd_angle_rate_rad_s,kappa,sd_kappa,"
                       "noise,chi2_per_dof,verdict,changed,u_f_mean_hz,u_split_hz,u_theta_w_rad,"
                       "u_tau_s,u_q,u_damping_anisotropy_per_s,u_theta_tau_rad,"
                       "u_angle_rate_rad_s,u_kappa,warnings,bias_v,temperature_c,exchanged,"
                       "operator,comment,lot"));
        QList<QByteArray> sets;
        QList<QByteArray> states;
        for (int row = 0; row < rows_of(table_).size(); ++row) {
            sets << field_of(table_, row, "set");
            states << field_of(table_, row, "status");
        }
        QCOMPARE(sets.join(' '), QByteArray("s1 s2 s3 broken s5 s6 gone s8 s9 twice s11 s12"));
        QCOMPARE(states.join(' '), QByteArray("ok ok ok 3 ok ok 3 ok ok 4 ok ok"));
        QVERIFY(table_.contains("# list: list.csv\n# sha256: "));
        QCOMPARE(field_of(table_, 0, "gyro"), QByteArray("G1"));
        QCOMPARE(field_of(table_, 0, "date"), QByteArray("2026-01-01"));
        QCOMPARE(field_of(table_, 0, "files"), QByteArray("\"a.wav;b.wav\""));
        QCOMPARE(field_of(table_, 0, "lot"), QByteArray("L1"));
        QCOMPARE(field_of(table_, 11, "lot"), QByteArray("\";L3\""));
        QCOMPARE(field_of(table_, 0, "verdict"), QByteArray());
    }

    // Status, sentence and numbers of a set are those of identify.
    void a_row_says_what_the_set_alone_says() {
        const QList<QByteArray> rows = rows_of(table_);
        int failed = 0;
        for (int row = 0; row < rows.size(); ++row) {
            const QByteArray set = field_of(table_, row, "set");
            const Outcome alone = run(
                {"identify", "--list", "list.csv", "--set", set, "-o", "alone.json", "--quiet"});
            const QByteArray status = field_of(table_, row, "status");
            if (alone.status != 0) {
                ++failed;
                QCOMPARE(status, QByteArray::number(alone.status));
                QByteArray sentence = alone.err.trimmed().mid(QByteArray("vybeg-cli: ").size());
                sentence.replace("\"", "\"\"");
                QVERIFY2(rows[row].contains(sentence), rows[row] + sentence);
                QVERIFY(!QFile::exists(path("json/" + set + ".json")));
                continue;
            }
            QCOMPARE(status, QByteArray("ok"));
            QCOMPARE(field_of(table_, row, "message"), QByteArray());
            QCOMPARE(file("json/" + set + ".json"), file("alone.json"));
            const QJsonObject result = object(file("alone.json"));
            QCOMPARE(field_of(table_, row, "model"), result["model"].toString().toUtf8());
            QCOMPARE(field_of(table_, row, "chi2_per_dof").toDouble(),
                     result["chi2_per_dof"].toDouble());
            for (const QByteArray name : {"f_mean_hz", "split_hz", "theta_w_rad", "tau_s", "q"}) {
                const QJsonValue quantity = result["resonator"][QLatin1String(name)];
                const QByteArray value = field_of(table_, row, name);
                QCOMPARE(value.isEmpty(), quantity["value"].isNull());
                QCOMPARE(value.toDouble(), quantity["value"].toDouble());
                QCOMPARE(field_of(table_, row, "sd_" + name).toDouble(), quantity["sd"].toDouble());
                QCOMPARE(field_of(table_, row, "u_" + name).toDouble(), quantity["u"].toDouble());
            }
        }
        QCOMPARE(failed, 3);
    }

    void several_sets_at_once_give_the_same_bytes() {
        for (const QStringList& options :
             {words("--jobs 2"), words("--jobs 5 --threads 1"), words("--jobs 100")}) {
            QCOMPARE(run("batch list.csv -o jobs.csv --json jobs", options).status, 0);
            QCOMPARE(file("jobs.csv"), table_);
            const QStringList results = QDir(path("json")).entryList(QDir::Files);
            QCOMPARE(QDir(path("jobs")).entryList(QDir::Files), results);
            QCOMPARE(results.size(), 9);
            for (const QString& name : results) {
                QCOMPARE(file("jobs/" + name), file("json/" + name));
            }
        }
        QVERIFY(!QFile::exists(path("jobs.csv.unfinished")));
    }

    // As GNU parallel and a Slurm array do it: the pieces together are the table.
    void set_by_set_gives_the_same_bytes() {
        QByteArray together;
        for (const QByteArray& row : rows_of(table_)) {
            const QByteArray set = row.left(row.indexOf(','));
            const Outcome one = run({"batch", "list.csv", "--only", set, "-o", "-", "--quiet"});
            QCOMPARE(one.status, 0);
            QCOMPARE(rows_of(one.out), QList<QByteArray>{row});
            if (together.isEmpty()) {
                together = one.out;
            } else {
                together += row + "\n";
            }
        }
        QCOMPARE(together, table_);
    }

    void a_set_without_result_is_reported_at_once() {
        const Outcome outcome = run("batch list.csv -o x.csv --quiet --json-log --jobs 2");
        QCOMPARE(outcome.status, 0);
        QStringList sets;
        for (const QByteArray& line : outcome.err_lines()) {
            const QJsonObject entry = object(line);
            QCOMPARE(entry["level"].toString(), QString("error"));
            VYBEG_AT_LEAST(entry["status"].toInt(), 3);
            sets << entry["set"].toString();
        }
        sets.sort();
        QCOMPARE(sets, (QStringList{"broken", "gone", "twice"}));
    }

    void a_folder_is_a_list_of_its_files() {
        QDir(folder_.path()).mkdir("folder");
        QVERIFY(QFile::copy(path("b.wav"), path("folder/2.wav")));
        QVERIFY(QFile::copy(path("a.wav"), path("folder/1.wav")));
        QVERIFY(put(path("folder/notes.txt"), "no table\n"));
        QVERIFY(put(path("folder/earlier.csv.unfinished"), "vybeg rows\n"));
        QVERIFY(put(path("folder/result.json"), "{}\n"));  // no file of samples is JSON
        for (int again = 0; again < 2; ++again) {  // neither this table nor an earlier one counts
            QCOMPARE(run("batch folder -o folder/out.csv --from 0.1").status, 0);
            const QByteArray table = file("folder/out.csv");
            QCOMPARE(rows_of(table).size(), 3);
            QCOMPARE(field_of(table, 0, "set"), QByteArray("1.wav"));
            QCOMPARE(field_of(table, 0, "status"), QByteArray("ok"));
            QCOMPARE(field_of(table, 1, "set"), QByteArray("2.wav"));
            QCOMPARE(field_of(table, 2, "status"), QByteArray("3"));
            QVERIFY(table.contains("# folder: folder\n"));
            QVERIFY(table.contains("# from: 0.1\n"));
            QVERIFY(put(path("folder/earlier.csv"), table));
        }
    }

    void the_verdict_is_that_of_the_gyro_s_passport() {
        QDir(folder_.path()).mkdir("passports");
        const QStringList first = words("identify --list list.csv --set s1");
        QCOMPARE(run(first + words("--passport passports/G1.json")).status, 0);
        // Another gyro: the split of its passport is twice as large.
        for (const auto& [name, start] : {std::pair{"x.wav", "0"}, std::pair{"y.wav", "0.7854"}}) {
            QCOMPARE(
                run({"simulate", "--seconds", "2", "--noise", "0.001", "--tau", "400", "--split",
                     "2e-3", "--theta-w", "0.2", "--two-theta-A", start, "-o", name})
                    .status,
                0);
        }
        QCOMPARE(run("identify x.wav y.wav --passport passports/G2.json").status, 0);
        QVERIFY(put(path("passports/s8.json"), "{}"));
        QVERIFY(put(path("gyros.csv"),
                    "set,file,gyro\nsame,a.wav,G1\nsame,b.wav,G1\nother,a.wav,G2\n"
                    "other,b.wav,G2\nnone,a.wav,G3\nnone,b.wav,G3\ns8,b.wav,\n"));
        QCOMPARE(run("batch gyros.csv -o v.csv --passport passports --json verdicts").status, 0);
        const QByteArray table = file("v.csv");
        QCOMPARE(field_of(table, 0, "verdict"), QByteArray("unchanged"));
        QCOMPARE(field_of(table, 0, "changed"), QByteArray());
        QCOMPARE(field_of(table, 1, "verdict"), QByteArray("changed"));
        QVERIFY2(field_of(table, 1, "changed").contains("split_hz"), table);
        QCOMPARE(field_of(table, 2, "verdict"), QByteArray());
        QCOMPARE(field_of(table, 2, "status"), QByteArray("ok"));
        // A passport that cannot be read; the name of the set is that of the gyro.
        QCOMPARE(field_of(table, 3, "status"), QByteArray("3"));
        QCOMPARE(run("compare passports/G2.json a.wav b.wav -o c.json").status, 0);
        QCOMPARE(object(file("verdicts/other.json"))["differences"],
                 object(file("c.json"))["differences"]);
    }

    // Conditions beside the result; a comparison that cannot be believed has no verdict.
    void a_serious_warning_takes_the_place_of_the_verdict() {
        QDir(folder_.path()).mkdir("others");
        QVERIFY(put(path("told.csv"),
                    "set,file,gyro,bias_v,temperature_c,operator,comment,lot\n"
                    "T,a.wav,H1,60,20,I. I.,quiet,L7\nT,b.wav,H1,60,21,I. I.,quiet,L7\n"));
        QCOMPARE(run("identify --list told.csv --passport others/H1.json").status, 0);
        QCOMPARE(run("batch told.csv -o t.csv --passport others").status, 0);
        const QByteArray fine = file("t.csv");
        QCOMPARE(field_of(fine, 0, "verdict"), QByteArray("unchanged"));
        QCOMPARE(field_of(fine, 0, "message"), QByteArray());
        QCOMPARE(field_of(fine, 0, "bias_v"), QByteArray("60"));
        QCOMPARE(field_of(fine, 0, "temperature_c"), QByteArray("\"20;21\""));
        QCOMPARE(field_of(fine, 0, "exchanged"), QByteArray());
        QCOMPARE(field_of(fine, 0, "operator"), QByteArray("I. I."));
        QCOMPARE(field_of(fine, 0, "comment"), QByteArray("quiet"));
        QCOMPARE(field_of(fine, 0, "lot"), QByteArray("L7"));
        // The passport's file has the gyro's name, its content another.
        QByteArray other = file("others/H1.json");
        QVERIFY(put(path("others/H1.json"), other.replace("\"H1\"", "\"H9\"")));
        QCOMPARE(run("batch told.csv -o t.csv --passport others").status, 0);
        const QByteArray table = file("t.csv");
        // field_of() knows no commas in quotes, which the message has.
        const QByteArray warned =
            QString::fromUtf8(table)
                .replace(QRegularExpression("\"The passport[^\"]*\""), "quoted")
                .toUtf8();
        QCOMPARE(field_of(warned, 0, "status"), QByteArray("ok"));
        QCOMPARE(field_of(warned, 0, "message"), QByteArray("quoted"));
        QCOMPARE(field_of(warned, 0, "verdict"), QByteArray());
        QCOMPARE(field_of(warned, 0, "changed"), QByteArray());
        QVERIFY2(table.contains("The passport is that of the gyro H9"), table);
        QVERIFY2(field_of(warned, 0, "warnings").startsWith("other-gyro"), table);
    }

    void names_cannot_lead_out_of_the_folder_of_results() {
        QVERIFY(put(path("names.csv"), "set,file\n../up,a.wav\n\"=1+1, \"\"x\"\"\",a.wav\n"));
        QCOMPARE(run("batch names.csv -o n.csv --json names").status, 0);
        QCOMPARE(QDir(path("names")).entryList(QDir::Files | QDir::Hidden, QDir::Name),
                 (QStringList{"%2E.%2Fup.json", "=1+1, \"x\".json"}));
        QVERIFY(rows_of(file("n.csv"))[1].startsWith("\"=1+1, \"\"x\"\"\","));
    }

    void a_name_too_long_for_a_file_is_found_before_the_work() {
        QVERIFY(put(path("names.csv"), "set,file\nA,a.wav\n" + QByteArray(300, 'x') + ",a.wav\n"));
        const Outcome outcome = run("batch names.csv -o n2.csv --json names");
        QCOMPARE(outcome.status, 2);
        QVERIFY2(outcome.err.contains("too long for a file"), outcome.err);
        QVERIFY(!QFile::exists(path("n2.csv.unfinished")));
        QCOMPARE(run("batch names.csv -o n2.csv").status, 0);
    }

    void an_unknown_column_keeps_its_name_or_gets_another() {
        QVERIFY(put(path("c.csv"), "file,status,my note\na.wav,new,\"a, b\"\n"));
        QCOMPARE(run("batch c.csv -o x.csv").status, 0);
        QCOMPARE(names_of(file("x.csv")).mid(44), (QList<QByteArray>{"list_status", "my note"}));
        QVERIFY(rows_of(file("x.csv"))[0].endsWith(",new,\"a, b\""));
    }

    void the_table_is_no_result_of_a_set_even_where_none_exists_yet() {
        QVERIFY(put(path("one.csv"), "set,file\nx,a.wav\n"));
        QVERIFY(QDir(folder_.path()).mkdir("same"));
        const Outcome outcome = run("batch one.csv -o same/x.json --json ./same/../same");
        QCOMPARE(outcome.status, 2);
        QVERIFY2(outcome.err.contains("it is an input, the table or the database"), outcome.err);
        QVERIFY(QDir(path("same")).isEmpty());
    }

    void a_set_is_named_once() {
        QVERIFY(put(path("gyros.csv"), "set,file,gyro\nA,a.wav,G1\nA,b.wav,G2\n"));
        const Outcome outcome = run("batch gyros.csv -o gyros-out.csv");
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
        QVERIFY2(outcome.err.contains("vybeg-cli: A: the recordings differ in the gyro"),
                 outcome.err);
        QVERIFY(field_of(file("gyros-out.csv"), 0, "message")
                    .startsWith("\"A: the recordings differ in the gyro"));
    }

    void wrong_usage_is_refused_with_its_reason_data() {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* arguments, int status, const char* part) {
            QTest::newRow(arguments) << arguments << status << part;
        };
        row("list.csv", 2, "--output is required");
        row("-o new.csv", 2, "LIST is required");
        row("list.csv a.wav -o new.csv", 2, "a.wav");
        row("list.csv -o new.csv --jobs 0", 2, "--jobs cannot be \"0\": it must be 1 to 1024.");
        row("list.csv -o new.csv --jobs two", 2, "--jobs cannot be \"two\"");
        row("list.csv -o new.csv --jobs 2 --jobs 2", 2, "--jobs is given twice.");
        row("list.csv -o new.csv --kappa 0", 2, "--kappa cannot be");
        row("list.csv -o new.csv --channels 1,1", 2, "--channels cannot be");
        row("list.csv -o new.csv --only s99", 2, "--only cannot be \"s99\": the sets of the list");
        row("list.csv -o new.csv --algorithm in-phase", 2, "--algorithm");
        row("list.csv -o new.xlsx", 5, "the ending \".xlsx\" is none of those");
        row("list.csv -o list.csv", 2, "it is the list of the recordings");
        row("list.csv -o a.wav", 2, "it is one of the recordings");
        row("list.csv -o - --resume", 2, "--resume needs a file");
        row("none.csv -o new.csv", 3, "none.csv: there is no such file");
        row("a.wav -o new.csv", 3, "column \"file\": the file holds no text.");
        QVERIFY(QDir(folder_.path()).mkpath("nothing"));
        row("nothing -o new.csv", 3, "the folder holds no recording");
        row("list.csv -o new.csv --passport none", 3, "none: there is no such file");
        row("list.csv -o none/new.csv", 5, "none/new.csv cannot be written");
        row("list.csv -o new.csv --json a.wav", 5, "a.wav cannot be written");
        row("list.csv -o new.csv --json ./new.csv", 2, "the table goes there already");
        row("list.csv -o new.csv --json -", 2, "it must be a folder");
        row("list.csv -o new.csv --json /proc/none", 5, "cannot be written");
    }

    void wrong_usage_is_refused_with_its_reason() {
        QFETCH(QString, arguments);
        QFETCH(int, status);
        QFETCH(QString, part);
        const QByteArray recording = file("a.wav");
        const Outcome outcome = run("batch", arguments.split(' '));
        VYBEG_EQUAL(outcome.status, status, outcome.err);
        QCOMPARE(outcome.err_lines().size(), 1);
        QVERIFY2(outcome.err.contains(part.toUtf8()), outcome.err);
        QVERIFY(!QFile::exists(path("new.csv")) && !QFile::exists(path("new.csv.unfinished")));
        QCOMPARE(file("list.csv"), twelve_sets);
        QCOMPARE(file("a.wav"), recording);
        QCOMPARE(temporaries(), QStringList());
    }

    // An input that has the name of a result is not replaced by it.
    void a_result_does_not_replace_an_input() {
        QDir(folder_.path()).mkdir("mixed");
        QVERIFY(QFile::copy(path("a.wav"), path("mixed/s1.json")));
        QVERIFY(put(path("mixed.csv"), "set,file\ns1,b.wav\ns2,mixed/s1.json\n"));
        const Outcome outcome = run("batch mixed.csv -o x.csv --json mixed");
        QCOMPARE(outcome.status, 2);
        QVERIFY2(outcome.err.contains("--json cannot be \"mixed/s1.json\""), outcome.err);
        QCOMPARE(file("mixed/s1.json"), file("a.wav"));
    }

    void a_table_does_not_replace_a_recording_of_its_folder() {
        QDir(folder_.path()).mkdir("taken");
        QVERIFY(QFile::copy(path("a.wav"), path("taken/1.wav")));
        QVERIFY(QFile::copy(path("b.wav"), path("taken/2.wav")));
        const Outcome outcome = run("batch taken -o taken/2.wav");
        QCOMPARE(outcome.status, 2);
        QVERIFY2(outcome.err.contains("it is one of the recordings"), outcome.err);
        QCOMPARE(file("taken/2.wav"), file("b.wav"));
    }
};

VYBEG_TEST(TestCliBatch)

}  // namespace test_cli_batch

#include "test_cli_batch.moc"
