// identify from files to JSON, on simulated recordings with known truth.
//
// Statistical model: each estimate's error is Gaussian with the deviation that the JSON gives, and
// is held to four of them; seeds are fixed.
#include "tests/app/resonator_runs.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <numbers>
#include <random>

namespace test_cli_identify {

using namespace vybeg::test;

namespace {

constexpr double pi = std::numbers::pi;
const QStringList set = set_of("r");

}  // namespace

class TestCliIdentify : public QObject, private CliFolder {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(simulate_set(folder_.path(), "r", "1e-3", 1));
        QVERIFY(simulate_still(folder_.path()));
        QVERIFY(put(path("noise.csv"), [] {
            QByteArray text = "C,D\n";
            std::mt19937 random(1);
            const auto number = [&random] {
                return QByteArray::number(static_cast<int>(random() >> 1));
            };
            for (int k = 0; k < 4000; ++k) {
                text += number() + "," + number() + "\n";
            }
            return text;
        }()));
        QVERIFY(put(path("no.json"), "{"));
    }

    void a_set_gives_its_resonator_within_its_deviations() {
        const Outcome outcome = run("identify", set + words("-o r.json"));
        QCOMPARE(outcome.err, QByteArray());
        QCOMPARE(outcome.out, QByteArray());
        QCOMPARE(outcome.status, 0);
        const QByteArray text = file("r.json");
        QVERIFY(!text.contains("nan") && !text.contains("inf,"));
        const QJsonObject json = object(text);
        const QJsonObject resonator = json["resonator"].toObject();
        VYBEG_LESS(deviations(resonator["f_mean_hz"], 5300.015), 4);
        VYBEG_LESS(deviations(resonator["split_hz"], 1e-3), 4);
        VYBEG_LESS(deviations(resonator["theta_w_rad"], 0.2, pi / 2), 4);
        VYBEG_LESS(deviations(resonator["tau_s"], 400), 4);
        VYBEG_LESS(deviations(resonator["q"], pi * 5300.015 * 400), 4);
        VYBEG_LESS(deviations(resonator["damping_anisotropy_per_s"], 3e-4), 4);
        VYBEG_LESS(deviations(resonator["theta_tau_rad"], -0.3, pi / 2), 4);
        VYBEG_LESS(deviations(resonator["angle_rate_rad_s"], -0.277 * 5e-5), 4);
        VYBEG_LESS(resonator["split_hz"]["sd"].toDouble(), 3e-6);
        for (int k = 0; k < 4; ++k) {
            const QJsonValue of_run = json["runs"][k];
            VYBEG_LESS(deviations(of_run["two_theta_A_rad"], k * pi / 4, pi), 4);
            VYBEG_LESS(deviations(of_run["a_A"], 1), 4);
            VYBEG_LESS(deviations(of_run["f_offset_hz"], 0.01 * k - 0.015), 4);
            VYBEG_LESS(deviations(of_run["split_sin_hz"], 1e-3 * std::sin(k * pi / 2 - 0.8)), 4);
        }
        // Modes by falling frequency, half a split beside the mean.
        VYBEG_LESS(deviations(json["modes"][0]["f_hz"], 5300.015 + 0.5e-3), 4.5);
        VYBEG_LESS(deviations(json["modes"][1]["f_hz"], 5300.015 - 0.5e-3), 4.5);
        const QJsonValue harmonics = json["drift_function"]["harmonics"];
        QCOMPARE(json["drift_function"]["order"].toInt(), 4);
        VYBEG_LESS(deviations(harmonics["mean_rad_s"], -0.277 * 5e-5), 4);
        VYBEG_LESS(deviations(harmonics["sin4_rad_s"], 0.75e-4 * std::cos(1.2)), 4);
        VYBEG_LESS(deviations(harmonics["cos4_rad_s"], 0.75e-4 * std::sin(1.2)), 4);
    }

    void the_json_has_the_members_of_the_interface() {
        QCOMPARE(run("identify", set + words("-o r.json")).status, 0);
        const QJsonObject json = object(file("r.json"));
        for (const char* name : {"program", "inputs", "settings", "warnings", "model", "modes",
                                 "resonator", "runs", "identifiable", "drift_function",
                                 "channel_balance", "modes_by", "noise", "chi2_per_dof"}) {
            QVERIFY2(json.contains(name), name);
        }
        QVERIFY(json["program"].toString().startsWith("vybeg-cli "));
        QCOMPARE(json["model"].toString(), QString("structured"));
        QVERIFY(json["warnings"].isArray());
        QCOMPARE(json["settings"]["model"].toString(), QString("auto"));
        const QJsonValue input = json["inputs"][1];
        QCOMPARE(input["name"].toString(), QString("r1.wav"));
        QCOMPARE(input["sha256"].toString().toLatin1(),
                 QCryptographicHash::hash(file("r1.wav"), QCryptographicHash::Sha256).toHex());
        QCOMPARE(input["seconds"].toDouble(), 333330 / 33333.0);
        QCOMPARE(input["rate_hz"].toDouble(), 33333.0);
        VYBEG_CLOSE(input["f0_hz"].toDouble(), 5300.01, 1e-3);
        const QJsonObject resonator = json["resonator"].toObject();
        for (const char* name :
             {"f_mean_hz", "split_hz", "theta_w_rad", "tau_s", "q", "damping_anisotropy_per_s",
              "theta_tau_rad", "angle_rate_rad_s", "kappa", "residual_rms"}) {
            QVERIFY2(is_quantity(resonator[name].toObject()), name);
        }
        QCOMPARE(json["modes"].toArray().size(), 2);
        for (const char* name : {"f_hz", "tau_s", "q"}) {
            QVERIFY2(is_quantity(json["modes"][0][name].toObject()), name);
        }
        QCOMPARE(json["runs"].toArray().size(), 4);
        for (const char* name : {"f_offset_hz", "a_A", "a_B", "two_theta_A_rad", "split_sin_hz",
                                 "q_envelope", "drift_hz_per_s"}) {
            QVERIFY2(is_quantity(json["runs"][3][name].toObject()), name);
        }
        QVERIFY(json["identifiable"]["split"].toBool());
        QVERIFY(json["identifiable"]["theta_w"].isBool());
        QCOMPARE(json["channel_balance"].toArray().size(), 4);
    }

    void uncertainties_sensitivities_and_waves_stand_in_the_json() {
        const auto identified = [&](const QStringList& more) {
            return object(run("identify", set + words("-o -") + more).out);
        };
        const QJsonObject json = identified(
            {"--tolerance", "skew=0.1deg,delay=10ns,phase-drift=1e-4,gain-drift=1e-4,kappa=0.1%"});
        QCOMPARE(json["settings"]["tolerance"].toString(),
                 QString("kappa=0.001,skew=0.1,delay=1e-08,phase-drift=1e-04,gain-drift=1e-04"));
        const QJsonObject usual = identified({});
        QCOMPARE(usual["settings"]["tolerance"].toString(), QString("none"));
        // What is not told is assumed, and marked so; zero is told.
        QCOMPARE(json["tolerances"]["skew"]["assumed"].toBool(true), false);
        QCOMPARE(json["tolerances"]["crosstalk"]["assumed"].toBool(), true);
        QCOMPARE(usual["tolerances"]["delay"]["value"].toDouble(), 1e-8);
        QCOMPARE(usual["tolerances"]["delay"]["assumed"].toBool(), true);
        QCOMPARE(usual["frequencies_by"].toString(), QString("clock of the recorder"));
        const QJsonObject axis = usual["resonator"]["theta_w_rad"].toObject();
        VYBEG_MORE(axis["u"].toDouble(),
                   0.9 * std::abs(axis["sensitivity"]["skew_deg"].toDouble()) * 0.1);
        const QJsonObject clocked = identified({"--tolerance", "skew=0,rate=10ppm"});
        QVERIFY(!clocked["tolerances"].toObject().contains("skew"));
        QCOMPARE(clocked["frequencies_by"].toString(), QString("tolerance"));
        VYBEG_CLOSE_RATIO(clocked["resonator"]["f_mean_hz"]["u"].toDouble(), 0.053, 0.01);
        VYBEG_LESS(clocked["resonator"]["theta_w_rad"]["u"].toDouble(), axis["u"].toDouble());
        const QJsonObject tau = json["resonator"]["tau_s"].toObject();
        QVERIFY2(is_quantity(tau), QJsonDocument(tau).toJson().constData());
        const QJsonObject by = tau["sensitivity"].toObject();
        QCOMPARE(by.keys(), (QStringList{"crosstalk", "cubic_hz", "damping_share", "delay_s",
                                         "eighth_rad_s", "gain_drift", "kappa", "phase_drift_rad",
                                         "pickoff_share", "skew_deg", "springs_hz"}));
        for (const QString& name : by.keys()) {
            QVERIFY2(by[name].isDouble(), qPrintable(name));
        }
        // A gain drift of 1e-4 over ten seconds is a decay rate of 0.5e-5/s of its half of the
        // power, at most: it enters u.
        VYBEG_MORE(tau["u"].toDouble(), 1.5 * tau["sd"].toDouble());
        VYBEG_WITHIN(1e-4 * by["gain_drift"].toDouble(), 0, tau["u"].toDouble());
        QVERIFY(!json["resonator"]["frequency_per_power"].toObject().contains("sensitivity"));
        for (int k = 0; k < 4; ++k) {
            const QJsonObject run = json["runs"][k].toObject();
            QCOMPARE(run["wave"].toObject().keys(),
                     (QStringList{"f_hz", "quadrature_rate_per_s", "tau_s", "theta_rate_rad_s"}));
            // The wave's own frequency lies between those of the two modes.
            const QJsonObject f = run["wave"]["f_hz"].toObject();
            VYBEG_CLOSE(f["value"].toDouble() - 5300, 0.01 * k, 0.5e-3 + 5 * f["sd"].toDouble());
            const QJsonObject tau_of_wave = run["wave"]["tau_s"].toObject();
            const double decay = 1 / tau_of_wave["value"].toDouble();
            VYBEG_CLOSE(decay, 1.0 / 400,
                        0.5 * 3e-4 + 5 * decay * decay * tau_of_wave["sd"].toDouble());
            QCOMPARE(run["direction"].toObject().keys(), (QStringList{"f_hz", "tau_s"}));
            QVERIFY(is_quantity(run["direction"]["f_hz"].toObject()));
        }
        QCOMPARE(json["modes_by"].toString(), QString("frequency"));
        QCOMPARE(json["noise"]["kind"].toString(), QString("white"));
        QVERIFY(json["noise"]["parts"].toArray().isEmpty());
        VYBEG_CLOSE(json["chi2_per_dof"].toDouble(), 1, 0.1);
    }

    void the_summary_begins_with_the_waves_and_shows_what_sd_leaves_out() {
        const Outcome outcome =
            run("identify", set + words("--tolerance gain-drift=1e-3,skew=1deg"));
        QCOMPARE(outcome.status, 0);
        const QByteArray text = outcome.out;
        QVERIFY2(text.startsWith("wave of r0.wav, means over the recording\n  f   "),
                 text.left(200).constData());
        VYBEG_LESS(text.indexOf("wave of r3.wav"), text.indexOf("resonator, structured"));
        QVERIFY(text.contains("  quadrature_rate"));
        const auto line_of = [&](const QByteArray& name, qsizetype from) {
            const qsizetype at = text.indexOf("\n" + name, from) + 1;
            return text.mid(at, text.indexOf('\n', at) - at);
        };
        const qsizetype resonator = text.indexOf("resonator, structured");
        const QByteArray tau = line_of("  tau ", resonator);
        QVERIFY2(tau.contains(" s, u "), tau.constData());
        const qsizetype table = text.indexOf("\nsensitivity:");
        VYBEG_MORE(table, resonator);
        QVERIFY(
            text.mid(table).contains("0.1 deg       10 ns    1e-4 rad        1e-4       0.001      "
                                     "  1e-4      10 uHz         1 %       0.1 %      10 uHz  "
                                     "1e-6 rad/s"));
        QVERIFY(text.contains("crosstalk 0.0001 (assumed)"));
        QVERIFY(text.contains("skew 1 deg, "));
        QVERIFY(text.contains("frequencies by the clock of the recorder"));
        VYBEG_EQUAL(line_of("  tau, s", table).simplified().split(' ').size(), 13);
        VYBEG_EQUAL(line_of("  theta_w, deg", table).simplified().split(' ').size(), 13);
    }

    void any_number_of_threads_gives_the_same_bytes() {
        const Outcome one = run("identify", set + words("-o - --threads 1"));
        const Outcome all = run("identify", set + words("-o -"));
        QCOMPARE(one.status, 0);
        QVERIFY(one.out == all.out);
        QVERIFY(!object(one.out).isEmpty());
    }

    void one_still_run_is_refused_its_split_with_a_reason() {
        const Outcome outcome = run("identify still.wav -o -");
        QCOMPARE(outcome.status, 0);
        const QJsonObject json = object(outcome.out);
        QVERIFY(json["resonator"]["split_hz"]["value"].isNull());
        const QString reason = json["resonator"]["split_hz"]["reason"].toString();
        QVERIFY2(reason.contains("recording that starts at"), qPrintable(reason));
        QVERIFY(json["resonator"]["theta_w_rad"]["value"].isNull());
        QVERIFY(!json["identifiable"]["split"].toBool());
        // What the wave did is given all the same, and so are the numbers of its direction.
        const QJsonValue still = json["runs"][0];
        const QJsonValue growth = still["wave"]["quadrature_rate_per_s"];
        VYBEG_LESS(deviations(growth, pi * 1e-6 * std::sin(pi / 2 - 0.8)), 4);
        VYBEG_LESS(growth["sd"].toDouble(), 3e-7);
        const double along = 0.5e-6 * std::cos(pi / 2 - 0.8);
        VYBEG_LESS(deviations(still["direction"]["f_hz"], 5300 + along), 4);
        VYBEG_LESS(still["direction"]["f_hz"]["sd"].toDouble(), 1e-7);
        VYBEG_LESS(deviations(still["direction"]["tau_s"], 400), 4);
        QVERIFY(json["resonator"]["tau_s"]["value"].isNull());
        QCOMPARE(json["drift_function"]["order"].toInt(), 0);
        QVERIFY(json["drift_function"]["curve"].isNull());
        QVERIFY(is_quantity(json["drift_function"]["harmonics"]["mean_rad_s"].toObject()));
        const Outcome summary = run("identify still.wav");
        QCOMPARE(summary.status, 0);
        QVERIFY(summary.out.contains("  split                     - "));
        QVERIFY(summary.out.contains(reason.toUtf8()));
    }

    void the_free_model_has_modes_and_no_axes() {
        const Outcome outcome = run("identify", set + words("-o - --model free"));
        QCOMPARE(outcome.status, 0);
        const QJsonObject json = object(outcome.out);
        QCOMPARE(json["model"].toString(), QString("free"));
        QVERIFY(json["resonator"].isNull());
        const QString reason = json["resonator_reason"].toString();
        QVERIFY(reason.endsWith('.'));
        QVERIFY(json["drift_function"]["curve"].isNull());
        QCOMPARE(json["drift_function"]["harmonics"]["mean_rad_s"]["reason"].toString(), reason);
        VYBEG_LESS(deviations(json["modes"][0]["f_hz"], 5300.015 + 0.5e-3), 4.5);
    }

    void options_of_the_signals_have_their_part() {
        const Outcome turned =
            run("identify",
                set + words("-o - --angle-zero 10 --from 1 --to 9 --kappa 1.0000001 --window 700"));
        QCOMPARE(turned.status, 0);
        const QJsonObject json = object(turned.out);
        VYBEG_LESS(deviations(json["resonator"]["theta_w_rad"], 0.2 - pi / 18, pi / 2), 4);
        QVERIFY(json["resonator"]["kappa"]["value"].isNull());
        QCOMPARE(json["settings"]["window"].toString(), QString("700"));
        QCOMPARE(json["runs"][0]["window_samples"].toInt(), 700);
        QCOMPARE(json["runs"][0]["windows"].toInt(), (299997 - 33333) / 700);
        const Outcome in_periods = run("identify r0.wav -o - --periods 100");
        QCOMPARE(object(in_periods.out)["runs"][0]["window_samples"].toInt(), 629);
    }

    void a_failure_has_its_status_and_one_sentence_data() {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* name, const QString& arguments, int status,
                            const QString& part) {
            QTest::newRow(name) << arguments << status << part;
        };
        row("no file", "identify", 2, "FILE");
        row("unknown model", "identify r0.wav --model rigid", 2, "auto, structured or free");
        row("unknown tolerance", "identify r0.wav --tolerance tilt=1", 2, "\"tilt\" is none of");
        row("negative tolerance", "identify r0.wav --tolerance skew=-1", 2, "zero or more");
        row("tolerance of nothing", "identify r0.wav --tolerance delay=nan", 2, "zero or more");
        row("tolerance twice", "identify r0.wav --tolerance skew=1,skew=1", 2, "given twice");
        row("an option of analyze alone", "identify r0.wav --hop 5", 2, "--hop");
        row("window of a few samples", "identify r0.wav --window 8", 2, "at least 16 samples");
        row("result over a recording", "identify r0.wav r1.wav -o r1.wav", 2, "the recordings");
        row("passport over a recording", "identify r0.wav --passport r0.wav", 2, "the recordings");
        row("two results in one", "identify r0.wav -o x.json --passport x.json", 2,
            "goes there already");
        row("second file missing", "identify r0.wav missing.wav", 3, "missing.wav: there is no");
        row("second file is no recording", "identify r0.wav no.json", 3, "no.json");
        row("no carrier", "identify noise.csv --rate 33333", 4, "noise.csv: no carrier");
        row("long window", "identify r0.wav --window 400000", 4, "r0.wav: the window of 400000");
        row("short window", "identify r0.wav --f0 1000 --window 30", 4, "two periods");
        row("too few windows", "identify r0.wav --window 200000", 4, "windows");
        row("no folder", "identify r0.wav -o none/x.json", 5, "none/x.json");
        row("full device", "identify r0.wav -o /dev/full", 5, "No space left");
    }

    void a_failure_has_its_status_and_one_sentence() {
        QFETCH(QString, arguments);
        QFETCH(int, status);
        QFETCH(QString, part);
        QCOMPARE(fault_of(run(arguments), status, part), QString());
        QCOMPARE(temporaries(), QStringList());
        QVERIFY(!QFile::exists(path("x.json")));
    }

    void warnings_name_their_file() {
        QVERIFY(QFile::copy(path("r0.wav"), path("early.wav")));
        QVERIFY(QFile::resize(path("early.wav"), 4000001));
        const Outcome outcome = run("identify early.wav r1.wav -o -");
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.err.startsWith("vybeg-cli: warning: early.wav: The file ends early"),
                 outcome.err);
        const QJsonValue warning = object(outcome.out)["warnings"][0];
        QCOMPARE(warning["kind"].toString(), QString("file-ends-early"));
        QCOMPARE(warning["input"].toString(), QString("early.wav"));
        const Outcome log = run("identify early.wav -o x2.json --json-log");
        const QList<QByteArray> lines = log.err_lines();
        QVERIFY(std::ranges::any_of(lines, [](const QByteArray& line) {
            return object(line)["level"] == "warning" && object(line)["input"] == "early.wav";
        }));
        const Outcome quiet = run("identify early.wav -o x2.json --quiet");
        QCOMPARE(quiet.err, QByteArray());
    }

    void timing_is_the_last_line_of_standard_error() {
        const Outcome outcome = run("identify", set + words("-o t.json --timing --threads 1"));
        QCOMPARE(outcome.status, 0);
        const QJsonObject timing = object(outcome.err_lines().last());
        QCOMPARE(timing.keys(), (QStringList{"carrier_s", "estimate_s", "fit_s", "open_s", "read_s",
                                             "threads", "windows", "windows_s", "write_s"}));
        QCOMPARE(timing["windows"].toInt(), 4 * (333330 / 500));
    }

    void a_signal_ends_it_cleanly() {
        QCOMPARE(run("simulate --seconds 300 --noise 0.001 --tau 400 -o long.wav").status, 0);
        QVERIFY(put(path("old.json"), "old"));
        QProcess process;
        start(process,
              {"identify", "long.wav", "-o", "old.json", "--threads", "1", "--window", "20"});
        QTRY_COMPARE_WITH_TIMEOUT(temporaries().size(), 1, 20000);
        QCOMPARE(process.state(), QProcess::Running);
        QCOMPARE(kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
        QVERIFY(process.waitForFinished(20000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 130);
        QCOMPARE(process.readAllStandardError(),
                 QByteArray("vybeg-cli: Interrupted; nothing was written.\n"));
        QCOMPARE(file("old.json"), QByteArray("old"));
        QCOMPARE(temporaries(), QStringList());
    }
};

VYBEG_TEST(TestCliIdentify)

}  // namespace test_cli_identify

#include "test_cli_identify.moc"
