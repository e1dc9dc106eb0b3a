// identify of logs of a lock-in and a phasemeter, as a process. The lock-in is the test's own.
#include "tests/app/batch_run.h"
#include "tests/app/phasor_logs.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <vector>

namespace test_cli_phasors {

using namespace vybeg::test;

class TestCliPhasors : public PhasorLogTest {
    Q_OBJECT

private slots:
    void initTestCase() { simulate_runs(); }

    void samples_and_their_lock_in_tell_one_resonator_data() {
        QTest::addColumn<int>("order");
        QTest::addColumn<double>("bandwidth");
        QTest::addColumn<int>("samples");
        QTest::addColumn<int>("frame");
        QTest::addColumn<double>("y_sign");
        QTest::addColumn<bool>("rms");
        const struct {
            double bandwidth;
            int samples;
        } filters[]{{8, 600}, {30, 150}, {120, 40}};
        for (int order = 1; order <= 8; ++order) {
            // What of the noise the filter leaves beyond half the rate of the rows folds back.
            const int denser = order == 1 ? 6 : order == 2 ? 2 : 1;
            for (int filter = 0; filter < 3; ++filter) {
                const int frame = (order + filter) % 4;
                const bool other = (order + frame) % 2 == 1;
                QTest::addRow("order %d, %g Hz, frame %d", order, filters[filter].bandwidth, frame)
                    << order << filters[filter].bandwidth << filters[filter].samples / denser
                    << frame << (other ? -1.0 : 1.0) << (filter == 1);
            }
        }
    }
    void samples_and_their_lock_in_tell_one_resonator() {
        QFETCH(int, order);
        QFETCH(double, bandwidth);
        QFETCH(int, samples);
        QFETCH(int, frame);
        QFETCH(double, y_sign);
        QFETCH(bool, rms);
        const auto kind = static_cast<Frame>(frame);
        QStringList arguments =
            words("identify -o -") +
            QStringList{"--phasors",
                        kind == Frame::fixed ? "fixed" : kind == Frame::pll ? "pll" : "common",
                        "--y-sign",
                        y_sign > 0 ? "+" : "-",
                        "--amplitude",
                        rms ? "rms" : "peak",
                        "--lock-in",
                        QString("%1,%2Hz").arg(order).arg(bandwidth)};
        if (kind != Frame::common_frequency) {
            arguments << "--f-ref" << QString::number(f_ref_hz);
        }
        QByteArray log;
        for (int k = 0; k < runs; ++k) {
            arguments << QString("log%1.csv").arg(k);
            log = log_of_run(k, {order, bandwidth, samples}, kind, y_sign,
                             rms ? std::numbers::sqrt2 : 1);
            write(arguments.last(), log);
        }
        const Outcome identified = run(arguments);
        VYBEG_EQUAL(identified.status, 0, identified.err);
        QVERIFY2(!identified.err.contains("turned the other way"), identified.err);
        const QJsonObject found = json_of(identified)["resonator"].toObject();
        const QJsonObject expected =
            resonator_of_samples({order, bandwidth, samples}, log.count('\n') - 1);
        for (const QString name :
             {"split_hz", "theta_w_rad", "tau_s", "angle_rate_rad_s", "damping_anisotropy_per_s"}) {
            const QJsonObject there = expected[name].toObject();
            const QJsonObject here = found[name].toObject();
            const double sd = there["sd"].toDouble();
            VYBEG_LESS(std::abs(here["value"].toDouble() - there["value"].toDouble()) / sd, 0.1,
                       qPrintable(name));
            VYBEG_LESS(std::abs(here["sd"].toDouble() / sd - 1), 0.1, qPrintable(name));
        }
        const double amplitude = json_of(identified)["runs"][0]["a_A"]["value"].toDouble();
        VYBEG_LESS(std::abs(amplitude - 1), 0.01);
    }

    void simulate_writes_the_log_of_a_lock_in() {
        const QStringList decay = words(
            "simulate -o lock.wav --seconds 10 --tau 40 --f0 5300.1 --noise 1e-3 --split 0.05");
        const Outcome made = run(decay + words("--lock-in 4,30Hz,200"));
        VYBEG_EQUAL(made.status, 0, made.err);
        const auto tau = [&](const QStringList& arguments) {
            const QJsonObject json = json_of(run(arguments));
            return json["runs"][0]["wave"]["tau_s"].toObject();
        };
        const QJsonObject of_samples = tau({"identify", "lock.wav", "-o", "-", "--from", "0.1"});
        const QJsonObject of_log =
            tau({"identify", "lock.phasors.csv", "-o", "-", "--phasors", "fixed", "--y-sign", "+",
                 "--amplitude", "peak", "--lock-in", "4,30"});
        const double sd = of_samples["sd"].toDouble();
        VYBEG_LESS(std::abs(of_log["value"].toDouble() - of_samples["value"].toDouble()), 0.5 * sd);
        VYBEG_LESS(std::abs(of_log["sd"].toDouble() / sd - 1), 0.1);
        for (const QString text : {"4,30", "9,30,200", "4,0,200"}) {
            QCOMPARE(run(decay + QStringList{"--lock-in", text}).status, 2);
        }
        const Outcome nameless = run("simulate -o - --lock-in 4,30,200");
        QCOMPARE(nameless.status, 2);
    }

    // A gain and an angle of the electrodes that are told count as for samples; what is of samples
    // is named.
    void calibration_of_a_log() {
        QStringList identify = words(
            "identify -o - --phasors fixed --f-ref 5300.1 --y-sign + --amplitude peak --lock-in "
            "4,30Hz");
        for (int k = 0; k < runs; ++k) {
            const QString name = QString("fixed%1.csv").arg(k);
            write(name, log_of_run(k, {4, 30, 150}, Frame::fixed, 1, 1));
            identify << name;
        }
        // Empty where the command fails.
        const auto resonator = [&](const QStringList& more) {
            return json_of(run(identify + more))["resonator"].toObject();
        };
        const auto value = [](const QJsonObject& of, const QString& name) {
            return of[name]["value"].toDouble();
        };
        const QJsonObject as_it_is = resonator({});
        const QJsonObject turned = resonator({"--angle-zero", "10"});
        const double sd = as_it_is["theta_w_rad"]["sd"].toDouble();
        VYBEG_CLOSE(value(as_it_is, "theta_w_rad") - value(turned, "theta_w_rad"), pi / 18, 2 * sd);
        const QJsonObject told = resonator({"--kappa", "0.8", "--tolerance", "kappa=0.5"});
        VYBEG_CLOSE(value(told, "theta_w_rad"), value(as_it_is, "theta_w_rad"), 2 * sd);
        VYBEG_CLOSE(value(told, "kappa"), 1, 0.002);
        const Outcome idle = run(identify + words("--window 600"));
        QVERIFY2(idle.err.contains("--window has no effect: a log holds no samples"), idle.err);
    }

    void analyze_writes_the_track_of_a_log() {
        write("track_of.csv", log_of_run(0, {4, 30, 150}, Frame::fixed));
        const QStringList analyze = words(
            "analyze track_of.csv -o - --phasors fixed --f-ref 5300.1 --y-sign + --amplitude peak");
        const Outcome outcome = run(analyze);
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
        QVERIFY(outcome.out.contains("# phasors: fixed\n"));
        QVERIFY(outcome.out.contains("# y-sign: +\n"));
        QVERIFY(!outcome.out.contains("# algorithm"));
        // 20 s in windows of 15 ms or more.
        VYBEG_WITHIN(outcome.out.count('\n'), 1500, 100);
        QCOMPARE(run(analyze + words("--offset auto")).err.count("--offset has no effect"), 1);
        const Outcome untold = run("analyze track_of.csv -o - --phasors fixed");
        QCOMPARE(untold.status, 2);
        QVERIFY(untold.out.isEmpty());
    }

    // What a list tells of logs in its columns is what the options tell.
    void a_batch_of_logs_is_what_identify_finds() {
        QStringList files;
        QByteArray list = "file;set;phasors;f-ref;y-sign;amplitude;lock-in;gyro\n";
        for (int k = 0; k < runs; ++k) {
            const QString name = QString("listed%1.csv").arg(k);
            write(name, log_of_run(k, {4, 30, 150}, Frame::fixed, -1, std::sqrt(2.0)));
            files << name;
            // One row tells it of the set.
            list += name.toUtf8() + (k == 0 ? ";A;fixed;5300,1;-;rms;4,30Hz;G1\n" : ";A;;;;;;\n");
        }
        list += "0.npy;B;;;;;;\n";
        write("logs.csv", list);
        const QJsonObject told =
            json_of(run("identify -o - --phasors fixed --f-ref 5300.1 --y-sign - --amplitude rms "
                        "--lock-in 4,30",
                        files));
        QVERIFY(told["resonator"]["tau_s"]["value"].toDouble() > 0);
        const Outcome batch = run("batch logs.csv -o - --json json --rate 33333");
        QVERIFY2(!batch.err.contains("formula"), batch.err);
        QCOMPARE(field_of(batch.out, 0, "status"), QByteArray("ok"));
        const QJsonObject listed = object(file("json/A.json"));
        for (const QString part : {"resonator", "modes", "runs", "settings", "model"}) {
            QVERIFY2(listed[part] == told[part], qPrintable(part));
        }
        QCOMPARE(listed["settings"]["y-sign"].toString(), QString("-"));
        QCOMPARE(listed["settings"]["lock-in"].toString(), QString("4,30"));
        // A set of recordings has no words about logs.
        const QJsonObject of_samples = object(file("json/B.json"));
        QVERIFY(!of_samples["settings"].toObject().contains("phasors"));
        const Outcome identified = run("identify --list logs.csv --set A -o -");
        QVERIFY(json_of(identified)["resonator"] == told["resonator"]);
    }

    void what_does_not_belong_together_is_refused() {
        write("one.csv", log_of_run(0, {4, 30, 150}, Frame::fixed));
        const auto said = [this](const QByteArray& rows) {
            write("mixed.csv", "file,set,phasors,f-ref,y-sign,amplitude\n" + rows);
            const Outcome outcome = run("identify --list mixed.csv --rate 33333");
            return outcome.status == 0 ? QByteArray("no refusal") : outcome.err;
        };
        const QByteArray mixed = said("one.csv,A,fixed,5300.1,+,peak\nmade.wav,A,,,,\n");
        QVERIFY2(mixed.contains("made.wav"), mixed.constData());
        const QByteArray differs = said("one.csv,A,fixed,5300.1,+,peak\n0.npy,A,common,,+,peak\n");
        QVERIFY2(differs.contains("\"common\" differs from \"fixed\" in line 2") &&
                     differs.contains("a set of its own"),
                 differs.constData());
        const QByteArray untold = said("one.csv,A,,,,\n");
        QVERIFY2(untold.contains("columns of a measurement list"), untold.constData());
        QVERIFY(run("simulate -o made.wav --seconds 1").status == 0);
        const QByteArray audio = said("one.csv,A,fixed,5300.1,+,peak\nmade.wav,A,,,,\n");
        QVERIFY2(audio.contains("made.wav is no log") &&
                     audio.contains("analyze and identify read recordings"),
                 audio.constData());
        // An option that has no part beside what the set has is told.
        const Outcome idle = run("identify 0.npy --rate 33333 --y-sign +");
        QVERIFY2(idle.err.contains("--y-sign has no effect"), idle.err);
    }

    // A moved part of a log, whose first seconds are those of a hand.
    void part_of_a_log() {
        QByteArray log = log_of_run(0, {4, 30, 150}, Frame::fixed);
        QList<QByteArray> lines = log.split('\n');
        for (qsizetype k = 1; k < 400; ++k) {
            lines[k] = lines[k].left(lines[k].indexOf(',')) + ",9,9,9,9";
        }
        write("hand.csv", lines.join('\n'));
        const QStringList choice = words(
            "identify hand.csv -o - --phasors fixed --f-ref 5300.1 --y-sign + --amplitude peak");
        const Outcome read = run(choice + words("--from 2"));
        VYBEG_EQUAL(read.status, 0, read.err);
        const QJsonObject wave = json_of(read)["runs"][0]["wave"].toObject();
        VYBEG_LESS(std::abs(wave["tau_s"]["value"].toDouble() - 60), 2.0);
        const Outcome none = run(choice + words("--from 200"));
        QCOMPARE(none.status, 4);
        QVERIFY2(none.err.contains("200"), none.err);
    }

    void what_no_data_show_is_asked_for_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("asked");
        const QStringList whole =
            words("--phasors fixed --f-ref 5300.1 --y-sign + --amplitude peak");
        QTest::newRow("sign") << words("--phasors fixed --f-ref 5300.1") << "--y-sign + or -";
        QTest::newRow("peak") << whole.mid(0, 6) << "--amplitude peak or rms";
        QTest::newRow("reference") << words("--phasors fixed") + whole.mid(4) << "give --f-ref";
        QTest::newRow("oscillator")
            << words("--phasors common") + whole.mid(4) << "frequency or phase";
        QTest::newRow("phases") << words("--phasors pll") + whole.mid(2) << "Pc";
        QTest::newRow("frame") << words("--phasors moving") << "fixed, common or pll";
        QTest::newRow("order") << whole + words("--lock-in 9,20") << "from 1 to 8";
        QTest::newRow("alone") << words("--y-sign +") << "--phasors";
    }
    void what_no_data_show_is_asked_for() {
        QFETCH(QStringList, options);
        QFETCH(QString, asked);
        write("asked.csv", log_of_run(0, {4, 30, 150}, Frame::fixed));
        const Outcome refused = run("identify asked.csv", options);
        QVERIFY2(refused.status == 2 || refused.status == 3, refused.err);
        QVERIFY2(refused.err.contains(asked.toUtf8()), refused.err);
    }

    // Phases that go on by the whole carrier, as a counter has them, are relative to no reference;
    // a column of deviations needs one.
    void absolute_phases_and_deviations_of_a_frequency() {
        // Empty where the command fails.
        const auto found = [&](const QString& name, const QStringList& more) {
            const Outcome read =
                run("identify -o - --y-sign + --amplitude peak", more + QStringList{name});
            return json_of(read)["runs"][0]["wave"]["f_hz"].toObject();
        };
        // Adds `hz` times the time, or a number, to the columns from `first` on.
        const auto with = [](const QByteArray& log, qsizetype first, double hz, double number) {
            QList<QByteArray> rows = log.split('\n');
            for (qsizetype k = 1; k < rows.size() && !rows[k].isEmpty(); ++k) {
                QList<QByteArray> fields = rows[k].split(',');
                for (qsizetype i = first; i < fields.size(); ++i) {
                    fields[i] = QByteArray::number(
                        fields[i].toDouble() + hz * fields[0].toDouble() + number, 'g', 15);
                }
                rows[k] = fields.join(',');
            }
            return rows.join('\n');
        };
        const LockIn filter{4, 30, 150};
        const QString reference = QString::number(f_ref_hz);
        for (const auto& [frame, name] :
             {std::pair{Frame::pll, "pll"}, std::pair{Frame::common_phase, "common"}}) {
            const QByteArray log = log_of_run(0, filter, frame);
            write("relative.csv", log);
            const double turn = frame == Frame::pll ? 1 : 2 * pi;
            write("absolute.csv", with(log, 5, f_ref_hz * turn, 0));
            const QJsonObject expected =
                found("relative.csv", {"--phasors", name, "--f-ref", reference});
            const QJsonObject here = found("absolute.csv", {"--phasors", name});
            VYBEG_LESS(std::abs(here["value"].toDouble() - expected["value"].toDouble()),
                       0.05 * expected["sd"].toDouble());
            const Outcome both =
                run("identify absolute.csv --y-sign + --amplitude peak --f-ref 5300.1 --phasors",
                    {name});
            QCOMPARE(both.status, 2);
            QVERIFY2(both.err.contains("it is relative to no reference"), both.err);
        }
        const QByteArray moving = log_of_run(0, filter, Frame::common_frequency);
        write("moving.csv", moving);
        write("deviations.csv", with(moving, 5, 0, -f_ref_hz));
        const QJsonObject whole = found("moving.csv", {"--phasors", "common"});
        const QJsonObject sum =
            found("deviations.csv", {"--phasors", "common", "--f-ref", reference});
        VYBEG_LESS(std::abs(sum["value"].toDouble() - whole["value"].toDouble()),
                   0.05 * whole["sd"].toDouble());
        const Outcome open =
            run("identify deviations.csv --y-sign + --amplitude peak --phasors common");
        QCOMPARE(open.status, 2);
        QVERIFY2(open.err.contains("column F holds deviations of a frequency"), open.err);
    }

    // Rows much faster than the filter repeat its noise: half of such logs had a knock or a step.
    void rows_within_the_memory_of_a_filter_raise_no_word() {
        for (int set = 0; set < 6; ++set) {
            const QString filter = set % 2 == 0 ? "8,0.7" : "2,1";
            QStringList logs;
            for (int k = 0; k < 2; ++k) {
                const QString name = QString("memory%1").arg(k);
                QCOMPARE(run({"simulate",
                              "-o",
                              name + ".npy",
                              "--seconds",
                              "20",
                              "--rate",
                              "10000",
                              "--f0",
                              "3010",
                              "--split",
                              "0.02",
                              "--theta-w",
                              "0.3",
                              "--tau",
                              "60",
                              "--noise",
                              "0.003",
                              "--seed",
                              QString::number(10 * set + k),
                              "--two-theta-A",
                              QString::number(0.1 + 0.37 * set + k * pi / 4),
                              "--lock-in",
                              filter + ",50"})
                             .status,
                         0);
                logs << name + ".phasors.csv";
            }
            const Outcome found = run("identify -o - --phasors fixed --y-sign + --amplitude peak",
                                      logs + QStringList{"--lock-in", filter});
            for (const auto& warning : json_of(found)["warnings"].toArray()) {
                QCOMPARE(warning.toObject()["kind"].toString(), QString("set-too-small"));
            }
            const Outcome refused =
                run("identify --phasors fixed --y-sign + --amplitude peak --f-ref 3011", logs);
            QCOMPARE(refused.status, 2);
            QVERIFY2(refused.err.contains("says that the reference is 3010"), refused.err);
        }
    }

    // Frames that the columns contradict.
    void a_wrong_frame_is_told() {
        const LockIn filter{4, 30, 150};
        const QString samples = path("0.npy");
        // Also where the frequency is missing in a row.
        QList<QByteArray> rows = log_of(samples, filter, Frame::common_frequency, 1, 1).split('\n');
        rows[1].truncate(rows[1].lastIndexOf(',') + 1);
        write("moves.csv", rows.join('\n'));
        const Outcome moves = identify_fixed({"moves.csv"}, {});
        QCOMPARE(moves.status, 2);
        QVERIFY2(moves.err.contains("the oscillator's frequency moves from 5299.8 Hz to 5300.4 Hz "
                                    "(column F)"),
                 moves.err);

        // Phases that the frame leaves aside.
        for (const auto& [frame, declared, right] :
             {std::tuple{Frame::pll, "fixed", "pll"}, std::tuple{Frame::pll, "common", "pll"},
              std::tuple{Frame::common_phase, "fixed", "common"}}) {
            write("aside.csv", log_of(samples, filter, frame, 1, 1));
            const Outcome aside =
                run("identify aside.csv --f-ref 5300.1 --y-sign + --amplitude peak --phasors",
                    {declared});
            QCOMPARE(aside.status, 2);
            QVERIFY2(aside.err.contains(QByteArray("choose --phasors ") + right), aside.err);
        }

        const std::vector<Complex> c = demodulated(samples_of(samples, 0), filter);
        const std::vector<Complex> d = demodulated(samples_of(samples, 1), filter);
        QByteArray own = "t,Xc,Yc,Xd,Yd,Pc (rad),Pd (rad)\n";
        for (std::size_t k = filter.settling(); k < c.size(); ++k) {
            const double t = static_cast<double>(k) * filter.samples / rate_hz;
            for (const double value : {t, c[k].real(), c[k].imag(), d[k].real(), d[k].imag(),
                                       std::arg(c[k]), std::arg(d[k])}) {
                own += QByteArray::number(value, 'g', 15) + ',';
            }
            own.back() = '\n';
        }
        write("own.csv", own);
        const Outcome twice =
            run("identify own.csv --phasors pll --f-ref 5300.1 --y-sign + --amplitude peak");
        QCOMPARE(twice.status, 2);
        QVERIFY2(twice.err.contains("is the phase of X + iY itself"), twice.err);
    }

    // The oscillator moves by itself: what its phase should take out of both channels is doubled.
    void a_wrong_sign_of_the_oscillator_is_told() {
        const QString samples = path("0.npy");
        for (const Frame frame : {Frame::common_phase, Frame::common_frequency}) {
            for (const double y_sign : {1.0, -1.0}) {
                write("osc.csv", log_of(samples, {4, 30, 150}, frame, y_sign, 1));
                for (const double told : {1.0, -1.0}) {
                    const Outcome read = run(
                        "identify osc.csv --f-ref 5300.1 --amplitude peak --phasors common -o -",
                        {"--y-sign", told > 0 ? "+" : "-"});
                    const bool named =
                        read.err.contains("turned the other way they are") &&
                        (json_of(read)["warnings"].toArray().isEmpty() ||
                         QJsonDocument(json_of(read)).toJson().contains("oscillator-backward"));
                    VYBEG_EQUAL(named, told != y_sign, read.err);
                }
            }
        }
    }

    // One time far behind the others: the memory was said to be too small.
    void a_log_whose_clock_jumps_is_refused() {
        QList<QByteArray> rows = log_of_run(0, {4, 30, 150}, Frame::fixed).split('\n');
        QByteArray& last = rows[rows.size() - 2];
        last = "1e9" + last.mid(last.indexOf(','));
        write("jumps.csv", rows.join('\n'));
        const Outcome refused = identify_fixed({"jumps.csv"}, {});
        QCOMPARE(refused.status, 3);
        QVERIFY2(refused.err.contains("Cut the recording where its clock jumps"), refused.err);
    }

    // 0.15 phasors a second of a split of 0.05 Hz.
    void phasors_that_fold_are_refused() {
        QByteArray log = "t,Xc,Yc,Xd,Yd\n";
        for (int k = 0; k < 400; ++k) {
            const double t = 6.7 * k;
            const Complex p = std::polar(std::exp(-t / 4000), 2 * pi * 0.025 * t + 0.3);
            const Complex q = std::polar(0.6 * std::exp(-t / 4000), -2 * pi * 0.025 * t);
            const Complex c = std::cos(0.3) * p - std::sin(0.3) * q;
            const Complex d = std::sin(0.3) * p + std::cos(0.3) * q;
            for (const double value : {t, c.real(), c.imag(), d.real()}) {
                log += QByteArray::number(value + 1e-5 * std::sin(1e4 * t), 'g', 15) + ',';
            }
            log += QByteArray::number(d.imag(), 'g', 15) + '\n';
        }
        write("slow.csv", log);
        const Outcome refused =
            run("identify slow.csv --phasors fixed --f-ref 5300 --y-sign + --amplitude peak");
        QCOMPARE(refused.status, 4);
        QVERIFY2(refused.err.contains("less than four times the split"), refused.err);
    }

private:
    // Of the samples that the phasors of a log show, in the windows of the log. What windows of
    // other lengths leave over at the end, up to a hundredth of a run, is worth 0.2 sd.
    QJsonObject resonator_of_samples(const LockIn& lock_in, qsizetype rows) const {
        const double step_s = lock_in.samples / rate_hz;
        const double delay_s = lock_in.order * lock_in.tau_s();
        const auto together = std::llround(std::max(0.015, delay_s / 10) / step_s);
        const qsizetype window = std::max<qsizetype>(together, 1) * lock_in.samples;
        const qsizetype windows = rows * lock_in.samples / window;
        const double from_s = (static_cast<double>(lock_in.settling()) - 0.5) * step_s - delay_s;
        constexpr double one_more = 2;  // the times are rounded to samples
        const double to_s = from_s + (static_cast<double>(windows * window) + one_more) / rate_hz;
        QStringList arguments = words("identify --rate 33333 -o -") +
                                QStringList{"--window", QString::number(window),
                                            "--from",   QString::number(from_s, 'g', 12),
                                            "--to",     QString::number(to_s, 'g', 12)};
        for (int k = 0; k < runs; ++k) {
            arguments << QString::number(k) + ".npy";
        }
        return json_of(run(arguments))["resonator"].toObject();
    }
};

VYBEG_TEST(TestCliPhasors, first)

}  // namespace test_cli_phasors

#include "test_cli_phasors.moc"
