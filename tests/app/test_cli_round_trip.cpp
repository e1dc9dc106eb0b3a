// simulate -> analyze -> truth, and what else the program says on its way.
//
// Statistical model: an error divided by its own standard deviation has mean square
// nu / (nu - 2) = 1.018, nu = 2 * 60 - 5 degrees of freedom in a window; over N independent windows
// that mean has a deviation of about sqrt(2/N).
#include "tests/app/cli_run.h"
#include "tests/app/track_table.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <numbers>

namespace test_cli_round_trip {

using namespace vybeg::test;

class TestCliRoundTrip : public QObject, private CliFolder {
    Q_OBJECT

private slots:
    void an_analysis_finds_the_truth_within_its_own_deviations_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QStringList>("simulate");
        QTest::addColumn<QStringList>("analyze");
        const QStringList none;
        QTest::newRow("wav") << "d.wav" << none << none;
        QTest::newRow("csv") << "d.csv" << none << none;
        QTest::newRow("npy as raw")
            << "d.npy" << none << words("--raw f64 --skip 128 --rate 33333");
        QTest::newRow("16 bits") << "d.wav" << words("--bits 16") << none;
        QTest::newRow("calibrated") << "d.wav" << words("--kappa 1.1 --offset 0.2,-0.1")
                                    << words("--kappa 1.1 --offset 0.2,-0.1");
        QTest::newRow("conjugate gradient")
            << "d.wav" << none << words("--algorithm conjugate-gradient");
    }

    void an_analysis_finds_the_truth_within_its_own_deviations() {
        QFETCH(QString, name);
        QFETCH(QStringList, simulate);
        QFETCH(QStringList, analyze);
        const Outcome simulated = run(
            QStringList{"simulate", "--demo", "--seconds", "4", "-o", name, "--truth", "t.csv"} +
            simulate);
        QCOMPARE(simulated.err, QByteArray());
        QCOMPARE(simulated.status, 0);
        const Outcome analyzed = run(QStringList{"analyze", name, "-o", "a.csv"} + analyze);
        QCOMPARE(analyzed.err, QByteArray());
        QCOMPARE(analyzed.status, 0);
        const TrackTable found(file("a.csv"));
        const TrackTable truth(file("t.csv"));
        QCOMPARE(found.rows(), qsizetype{133332 / 60});
        QCOMPARE(truth.rows(), found.rows());
        const auto found_time = found.column("t_s");
        const auto true_time = truth.column("t_s");
        for (std::size_t row = 0; row < found_time.size(); ++row) {
            VYBEG_CLOSE(found_time[row], true_time[row], 1e-9);
        }
        for (const char* column : {"a_A", "a_B", "two_theta_A_rad", "alpha_rad", "f_Hz"}) {
            const auto values = found.column(column);
            const auto sds = found.column((QByteArray("sd_") + column).constData());
            const auto expected = truth.column(column);
            double mean_square = 0;
            double worst = 0;
            for (std::size_t row = 0; row < values.size(); ++row) {
                double error = values[row] - expected[row];
                if (qstrcmp(column, "alpha_rad") == 0) {
                    error = std::remainder(error, 2 * std::numbers::pi);
                }
                const double ratio = error / sds[row];
                mean_square += ratio * ratio / static_cast<double>(values.size());
                worst = largest_of({worst, std::abs(ratio)});
            }
            const double deviation = std::sqrt(2 / static_cast<double>(values.size()));
            VYBEG_CLOSE(mean_square, 1.018, 4.5 * deviation, qPrintable(column));
            VYBEG_LESS(worst, 6, qPrintable(QString("%1: %2").arg(column).arg(worst)));
        }
    }

    // One value for each departure, all unlike their defaults, in the truth's header as typed; each
    // alone changes the samples.
    void every_departure_of_a_simulation_is_an_option() {
        const QList<QPair<QString, QString>> options{{"frequency-drift", "0.25"},
                                                     {"settling", "-0.5"},
                                                     {"settling-time", "0.125"},
                                                     {"frequency-per-power", "3"},
                                                     {"damping-per-power", "0.75"},
                                                     {"same-projection", "0.75"},
                                                     {"delay", "1e-06"},
                                                     {"skew", "0.5"},
                                                     {"crosstalk", "0.0625"},
                                                     {"phase-drift", "0.375"},
                                                     {"gain-drift", "-0.25"},
                                                     {"pick-off-cubic", "0.03125"},
                                                     {"carrier-noise", "0.0078125"},
                                                     {"modulation-noise", "0.015625"},
                                                     {"carrier-noise-width", "2"},
                                                     {"phase-noise", "0.001953125"},
                                                     {"hum", "0.1,60,1.5"},
                                                     {"mode-beside", "990,0.5,0.25,1,2,3"},
                                                     {"lose", "100:3,200:-4"}};
        const QStringList start = words("simulate --seconds 0.05 -o x.csv");
        QCOMPARE(run(start).status, 0);
        const QByteArray plain = file("x.csv");
        QStringList all = start + words("--truth xt.csv --mode-beside 1,2,3,4,5,6");
        for (const auto& [name, value] : options) {
            const QStringList option{"--" + name, value};
            all += option;
            // What shapes another departure acts with it alone.
            QStringList with;
            if (name == "settling-time") {
                with = {"--settling", "1"};
            } else if (name == "carrier-noise-width") {
                with = {"--carrier-noise", "1e-3"};
            }
            QCOMPARE(run(start + with).status, 0);
            const QByteArray without = file("x.csv");
            QVERIFY(with.isEmpty() == (without == plain));
            const Outcome changed = run(start + with + option);
            QCOMPARE(changed.err, QByteArray());
            QCOMPARE(changed.status, 0);
            QVERIFY2(file("x.csv") != without, qPrintable(name));
        }
        const Outcome together = run(all);
        QCOMPARE(together.err, QByteArray());
        QCOMPARE(together.status, 0);
        // 1666 frames, a line of names, 3 lost, 4 doubled.
        QCOMPARE(file("x.csv").count('\n'), qsizetype{1668});
        const QList<QByteArray> header = TrackTable(file("xt.csv")).header();
        for (const auto& [name, value] : options) {
            const QByteArray line = (name + ": " + value).toLatin1();
            QVERIFY2(header.contains(line), line + " is not in " + header.join("; "));
        }
        QVERIFY(header.contains("mode-beside: 1,2,3,4,5,6"));
        // Friction and drive exclude a dependence on the power.
        const QList<QPair<QString, QString>> not_free{
            {"dry-friction", "0.5"}, {"air-friction", "0.25"}, {"drive", "2"}};
        for (const auto& [name, value] : not_free) {
            QCOMPARE(run(start + QStringList{"--" + name, value}).status, 0);
            QVERIFY2(file("x.csv") != plain, qPrintable(name));
        }
        QCOMPARE(run(start + words("--drive 2")).status, 0);
        const QByteArray driven = file("x.csv");
        for (const char* instant : {"--drive-from", "--drive-to"}) {
            QCOMPARE(run(start + QStringList{"--drive", "2", instant, "0.02"}).status, 0);
            QVERIFY2(file("x.csv") != driven, instant);
        }
        QVERIFY(run(start + words("--drive 2 --damping-per-power 1")).status != 0);
        for (const QStringList& wrong :
             {words("--lose 100"), words("--lose a:3"), words("--hum 1,2"),
              words("--mode-beside 1,2,3"), words("--skew x")}) {
            QCOMPARE(run(start + wrong).status, 2);
        }
        QCOMPARE(run(start + words("--lose 5000:3")).status, 4);
    }

    void info_as_json_has_the_members_of_the_interface() {
        QCOMPARE(run("simulate --seconds 0.5 -o i.wav").status, 0);
        const Outcome info = run("info i.wav --json");
        QCOMPARE(info.status, 0);
        const QJsonObject json = object(info.out);
        QCOMPARE(json.keys(), (QStringList{"channels", "check", "format", "frames", "rate_from",
                                           "rate_hz", "seconds", "sha256", "start"}));
        QCOMPARE(json["frames"].toInt(), 16666);
        QCOMPARE(json["rate_hz"].toDouble(), 33333.0);
        QCOMPARE(json["rate_from"].toString(), QString("file"));
        QCOMPARE(json["seconds"].toDouble(), 16666 / 33333.0);
        QVERIFY(json["start"].isString());
        QVERIFY(json["format"].toString().contains("WAV"));
        QCOMPARE(json["check"].toArray(), QJsonArray());
        QCOMPARE(json["channels"].toArray().size(), 2);
        QCOMPARE(json["channels"][0].toObject().keys(), (QStringList{"name", "unit"}));
        const QByteArray hash =
            QCryptographicHash::hash(file("i.wav"), QCryptographicHash::Sha256).toHex();
        QCOMPARE(json["sha256"].toString().toLatin1(), hash);
    }

    void info_tells_what_is_wrong_with_the_file() {
        QCOMPARE(run("simulate --seconds 0.5 -o i.wav").status, 0);
        QVERIFY(QFile::resize(path("i.wav"), 100000));
        const QJsonObject json = object(run("info i.wav --json").out);
        QCOMPARE(json["check"].toArray().size(), 1);
        const QJsonObject check = json["check"][0].toObject();
        QCOMPARE(check.keys(), (QStringList{"count", "first_frame", "kind", "severity", "text"}));
        QCOMPARE(check["kind"].toString(), QString("file-ends-early"));
        QVERIFY(check["text"].toString().contains("16666"));
        const Outcome text = run("info i.wav");
        QCOMPARE(text.status, 0);
        QVERIFY(text.out.contains("33333 Hz (file)"));
        QVERIFY(text.out.contains(check["text"].toString().toUtf8()));
    }

    // Of times, too, whose steps are no numbers of the machine.
    void info_tells_the_rate_in_its_digits() {
        QCOMPARE(run("simulate --seconds 0.5 -o i.csv").status, 0);
        const Outcome text = run("info i.csv");
        QVERIFY2(text.out.contains("\nrate      33333 Hz (time column"), text.out);
        QCOMPARE(json_of(run("info i.csv --json"))["rate_hz"].toDouble() - 33333, 0.0);
    }

    void the_track_names_its_program_input_and_settings() {
        QCOMPARE(run("simulate --seconds 0.5 -o h.wav").status, 0);
        QCOMPARE(run("analyze h.wav -o h.csv --window 63 --from 0.1").status, 0);
        const TrackTable track(file("h.csv"));
        const QByteArray hash =
            QCryptographicHash::hash(file("h.wav"), QCryptographicHash::Sha256).toHex();
        QVERIFY(track.header().value(0).startsWith("vybeg-cli "));
        for (const QByteArray& line :
             {QByteArray("input: h.wav"), "sha256: " + hash, QByteArray("window: 63"),
              QByteArray("hop: 63"), QByteArray("from: 0.1"),
              QByteArray("algorithm: maximum-likelihood")}) {
            QVERIFY2(track.header().contains(line), line.constData());
        }
        const auto f0 = std::ranges::find_if(
            track.header(), [](const QByteArray& line) { return line.startsWith("f0_Hz: "); });
        QVERIFY(f0 != track.header().end());
        // A hundredth of the bin of 0.4 s.
        VYBEG_CLOSE(f0->mid(7).toDouble(), 5300, 0.025);
    }

    void standard_output_gets_the_same_bytes_as_a_file_for_any_number_of_threads() {
        QCOMPARE(run("simulate --demo --seconds 2 -o o.wav").status, 0);
        QCOMPARE(run("analyze o.wav -o o.csv --threads 1").status, 0);
        const Outcome analyzed = run("analyze o.wav -o - --threads 2");
        QCOMPARE(analyzed.status, 0);
        QVERIFY(analyzed.out == file("o.csv"));
        QCOMPARE(TrackTable(analyzed.out).rows(), qsizetype{66666 / 60});
        QCOMPARE(run("simulate --demo --seconds 0.1 -o o2.csv").status, 0);
        QVERIFY(run("simulate --demo --seconds 0.1 -o -").out == file("o2.csv"));
    }

    void timing_is_the_last_line_of_standard_error() {
        QCOMPARE(run("simulate --seconds 0.5 -o z.wav").status, 0);
        QVERIFY(QFile::resize(path("z.wav"), 100000));
        const Outcome analyzed = run("analyze z.wav -o z.csv --timing --threads 1");
        QCOMPARE(analyzed.status, 0);
        QCOMPARE(analyzed.err_lines().size(), 2);
        QVERIFY(analyzed.err_lines()[0].startsWith("vybeg-cli: warning: "));
        const QJsonObject timing = object(analyzed.err_lines()[1]);
        QCOMPARE(timing.keys(), (QStringList{"carrier_s", "estimate_s", "read_s", "threads",
                                             "windows", "write_s"}));
        QCOMPARE(timing["windows"].toInteger(), TrackTable(file("z.csv")).rows());
        QCOMPARE(timing["threads"].toInt(), 1);
        for (const char* part : {"carrier_s", "estimate_s", "read_s", "write_s"}) {
            VYBEG_MORE(timing[part].toDouble(-1), 0);
            VYBEG_LESS(timing[part].toDouble(), 10);
        }
    }

    void the_json_log_is_one_object_per_line() {
        QCOMPARE(run("simulate --seconds 0.5 -o j.wav").status, 0);
        QVERIFY(QFile::resize(path("j.wav"), 100000));
        const Outcome analyzed = run("analyze j.wav -o j.csv --json-log");
        QCOMPARE(analyzed.status, 0);
        QStringList levels;
        for (const QByteArray& line : analyzed.err_lines()) {
            const QJsonObject entry = object(line);
            QVERIFY2(
                entry["level"].isString() && entry["code"].isString() && entry["text"].isString(),
                line.constData());
            levels << entry["level"].toString();
        }
        QVERIFY(levels.contains("warning") && levels.contains("progress"));
        const Outcome missing = run("analyze none.wav -o j.csv --json-log");
        QCOMPARE(missing.status, 3);
        QCOMPARE(missing.err_lines().size(), 1);
        const QJsonObject error = object(missing.err);
        QCOMPARE(error["level"].toString(), QString("error"));
        QCOMPARE(error["code"].toString(), QString("file-missing"));
        QCOMPARE(error["status"].toInt(), 3);
        const Outcome usage = run("analyze --json-log --no-such-option");
        QCOMPARE(usage.status, 2);
        QCOMPARE(object(usage.err)["status"].toInt(), 2);
    }

    void quiet_leaves_only_errors() {
        QCOMPARE(run("simulate --seconds 0.5 -o q.wav").status, 0);
        QVERIFY(QFile::resize(path("q.wav"), 100000));
        const Outcome analyzed = run("analyze q.wav -o q.csv --quiet");
        QCOMPARE(analyzed.status, 0);
        QCOMPARE(analyzed.err, QByteArray());
        QVERIFY(TrackTable(file("q.csv")).header().join().contains("warning: The file ends early"));
        QCOMPARE(run("analyze none.wav -o q.csv --quiet").err_lines().size(), 1);
    }

    // Three gaps are one line with a count; a note and each place by itself are for --verbose.
    void a_kind_of_warning_is_one_line_unless_all_are_asked_for() {
        QCOMPARE(run("simulate --demo --seconds 0.5 -o whole.csv").status, 0);
        QList<QByteArray> lines = file("whole.csv").split('\n');
        for (const int gap : {9000, 6000, 3000}) {
            lines.remove(gap, 50);
        }
        QVERIFY(put(path("gaps.csv"), "# a comment\n" + lines.join('\n')));
        const Outcome few = run("analyze gaps.csv -o gaps.track.csv");
        QCOMPARE(few.status, 0);
        QCOMPARE(few.err_lines().size(), 1);
        QVERIFY2(few.err.startsWith("vybeg-cli: warning: 50 samples are missing at 0.08997") &&
                     few.err.contains("(And 2 more places; 150 samples in all.)"),
                 few.err);
        const Outcome all = run("analyze gaps.csv -o gaps.track.csv --verbose");
        QCOMPARE(all.err.count("vybeg-cli: warning: 50 samples are missing"), 3);
        QVERIFY2(all.err.trimmed().endsWith("header or comment lines were passed over.") &&
                     all.err.count("vybeg-cli: note: ") == 1,
                 all.err);
        const Outcome info = run("info gaps.csv");
        QCOMPARE(info.out.count("check     50 samples are missing"), 1);
        QCOMPARE(info.out.count("\nnote      "), 1);
        QCOMPARE(run("info gaps.csv --verbose").out.count("check     50 samples"), 3);
        const Outcome log = run("analyze gaps.csv -o gaps.track.csv --json-log");
        QStringList severities;
        for (const QByteArray& line : log.err_lines()) {
            const QJsonObject entry = object(line);
            if (entry["level"] == "warning") {
                severities << entry["severity"].toString();
            }
        }
        QCOMPARE(severities, (QStringList{"warning", "warning", "warning", "note"}));
    }

    void help_and_version_end_well() {
        const Outcome version = run("--version");
        QCOMPARE(version.status, 0);
        QCOMPARE(version.out, QByteArray("vybeg-cli " VYBEG_VERSION "\n"));
        const Outcome help = run("analyze --help");
        QCOMPARE(help.status, 0);
        for (const QString& option :
             words("--algorithm --window --periods --snap --hop --f0 --initial --start "
                   "--from --to --band --filter --channels --rate --kappa --offset --delay "
                   "--angle-zero --raw --raw-channels --skip --scale --threads --quiet "
                   "--json-log --timing --variables --verbose")) {
            QVERIFY2(help.out.contains(option.toUtf8()), qPrintable(option));
        }
        const Outcome simulate = run("simulate --help");
        for (const QString& option :
             words("--seconds --rate --f0 --a-A --a-B --two-theta-A --alpha --split "
                   "--theta-w --tau --damping-anisotropy --theta-tau --omega --bryan "
                   "--noise --kappa --offset --bits --full-scale --seed --frequency-drift "
                   "--settling --settling-time --frequency-per-power --damping-per-power "
                   "--dry-friction --air-friction --drive --drive-from --drive-to "
                   "--same-projection --delay --skew --crosstalk --phase-drift "
                   "--gain-drift --pick-off-cubic --carrier-noise --modulation-noise "
                   "--carrier-noise-width --phase-noise --hum --mode-beside --lose --truth "
                   "--demo")) {
            QVERIFY2(simulate.out.contains(option.toUtf8()), qPrintable(option));
        }
    }
};

VYBEG_TEST(TestCliRoundTrip)

}  // namespace test_cli_round_trip

#include "test_cli_round_trip.moc"
