// identify of tracks and of logs without a phase, as a process.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include <cmath>
#include <numbers>
#include <utility>

namespace test_cli_powers {

using namespace vybeg::test;

class TestCliPowers : public QObject, private CliFolder {
    Q_OBJECT

private slots:
    void initTestCase() {
        for (int k = 0; k < 3; ++k) {
            const QString name = QString::number(k);
            QCOMPARE(run("simulate --seconds 12 --split 2e-3 --theta-w 0.3 --tau 400 --noise 1e-3 "
                         "--damping-anisotropy 3e-4 --theta-tau 0.7 --omega 2e-3",
                         {"-o", name + ".wav", "--seed", name, "--two-theta-A",
                          QString::number(0.2 + k * std::numbers::pi / 4)})
                         .status,
                     0);
            recordings_ << name + ".wav";
            for (const QString ending : {"csv", "npz"}) {
                QCOMPARE(
                    run({"analyze", name + ".wav", "-o", name + "." + ending, "--window", "500"})
                        .status,
                    0);
            }
            tracks_ << name + ".csv";
            packed_ << name + ".npz";
        }
    }

    void tracks_and_samples_tell_one_resonator() {
        const Outcome samples = run("identify -o -", recordings_);
        QCOMPARE(samples.status, 0);
        const QJsonObject expected = json_of(samples)["resonator"].toObject();
        for (const QStringList& files : {tracks_, packed_}) {
            const Outcome tracks = run("identify -o - --columns a,b,theta", files);
            QCOMPARE(tracks.status, 0);
            const QJsonObject found = json_of(tracks)["resonator"].toObject();
            int compared = 0;
            for (const QString name : {"split_hz", "theta_w_rad", "tau_s",
                                       "damping_anisotropy_per_s", "angle_rate_rad_s"}) {
                const QJsonObject there = expected[name].toObject();
                const QJsonObject here = found[name].toObject();
                if (there["value"].isDouble()) {
                    QVERIFY2(here["value"].isDouble(),
                             qPrintable(name + here["reason"].toString()));
                    VYBEG_LESS(std::abs(here["value"].toDouble() - there["value"].toDouble()),
                               there["sd"].toDouble(), qPrintable(name));
                    ++compared;
                }
            }
            VYBEG_AT_LEAST(compared, 4);
            for (const QString name : {"f_mean_hz", "q"}) {
                QVERIFY(found[name]["value"].isNull());
                QVERIFY(found[name]["reason"].toString().contains("no phase"));
            }
            QVERIFY(json_of(tracks)["inputs"][0]["f0_hz"].isNull());
            QCOMPARE(json_of(tracks)["settings"].toObject()["columns"].toString(),
                     QString("a,b,theta"));
        }
    }

    void a_track_of_a_track_is_that_track() {
        const Outcome again =
            run({"analyze", tracks_.front(), "--columns", "a,b,theta", "-o", "-"});
        VYBEG_EQUAL(again.status, 0, again.err);
        QVERIFY(again.out.contains("# columns: a,b,theta\n"));
        const auto row = [](const QByteArray& text, int number) {
            return text.split('\n').at(text.count("# ") + 1 + number).split(',');
        };
        const QList<QByteArray> expected = row(file(tracks_.front()), 300);
        const QList<QByteArray> found = row(again.out, 300);
        for (int column = 0; column < 4; ++column) {
            VYBEG_CLOSE(found[column].toDouble(), expected[column].toDouble(), 1e-12);
        }
        QCOMPARE(found[4], QByteArray("nan"));  // alpha
        QCOMPARE(found[5], QByteArray("nan"));  // f
        const Outcome delayed = run(
            {"analyze", tracks_.front(), "--columns", "a,b,theta", "--delay", "1us", "-o", "-"});
        QCOMPARE(delayed.status, 2);
        QVERIFY2(delayed.err.contains("a log without a phase has no frequency"), delayed.err);
    }

    void a_passport_of_tracks_compares_with_samples() {
        QCOMPARE(run("identify --columns a,b,theta --passport p.json", tracks_).status, 0);
        const Outcome compared = run("compare p.json", recordings_);
        QCOMPARE(compared.status, 0);
        QVERIFY(compared.out.contains("unchanged: by"));
        QVERIFY(!compared.out.contains("\n  split                     changed"));
    }

    void powers_of_another_unit_are_refused_and_an_offset_is_told() {
        write_powers("good.csv", 1, 0);
        write_powers("milli.csv", 1000, 0);
        write_powers("kilo.csv", 1e-3, 0);
        write_powers("offset.csv", 1, 5e-3);
        const QStringList identify = words("identify --columns E,R,S,Q");
        const Outcome good = run(identify + QStringList{"good.csv"});
        QCOMPARE(good.status, 0);
        QVERIFY2(!good.err.contains("E^2"), good.err);
        const Outcome milli = run(identify + QStringList{"milli.csv"});
        QCOMPARE(milli.status, 4);
        QVERIFY2(milli.err.contains("milli.csv: R^2 + S^2 + Q^2 is 0.0001 % of E^2"), milli.err);
        const Outcome kilo = run(identify + QStringList{"kilo.csv"});
        QCOMPARE(kilo.status, 2);
        QVERIFY2(kilo.err.contains("E is smaller than R in 400 rows of 400"), kilo.err);
        const Outcome offset = run(identify + QStringList{"offset.csv"});
        QCOMPARE(offset.status, 0);
        QVERIFY2(offset.err.contains("offset.csv: R^2 + S^2 + Q^2 differs from E^2 by"),
                 offset.err);
        QVERIFY2(!offset.err.contains("inf"), offset.err);
    }

    void exchanged_columns_are_refused() {
        write_powers("exchanged.csv", 1, 0);
        for (const auto& [columns, file] :
             {std::pair<QString, QString>{"E=S,R,S=E,Q", "exchanged.csv"},
              {"a=a_B,b=a_A,theta", tracks_.front()}}) {
            const Outcome refused = run({"identify", "--columns", columns, file});
            QCOMPARE(refused.status, 2);
            QVERIFY2(refused.err.contains("exchanged or have unlike units"), refused.err);
        }
    }

    // A logger that writes a row again changes nothing.
    void rows_twice_there_count_once() {
        write_powers("once.csv", 1, 0);
        QList<QByteArray> lines = file("once.csv").split('\n');
        for (qsizetype k = 381; k > 20; k -= 20) {
            lines.insert(k, lines[k]);
        }
        QVERIFY(put(path("twice.csv"), lines.join('\n')));
        const auto wave = [this](const QString& name) {
            const Outcome outcome = run({"identify", "--columns", "E,R,S,Q", "-o", "-", name});
            return json_of(outcome)["runs"][0]["wave"].toObject();
        };
        const QJsonObject expected = wave("once.csv");
        VYBEG_CLOSE(expected["tau_s"]["value"].toDouble(), 20, 1e-6);
        QCOMPARE(wave("twice.csv"), expected);
    }

    // A delay of D is a phase at the carrier, which a log without a phase does not have.
    void a_delay_counts_at_the_carrier() {
        const auto identify = [this](const QStringList& more) {
            return run("identify -o - --columns a,b,theta", more + tracks_);
        };
        const Outcome refused = identify({"--tolerance", "delay=1us"});
        QCOMPARE(refused.status, 2);
        QVERIFY2(refused.err.contains("--tolerance delay"), refused.err);
        const auto uncertainty = [&](const QStringList& more) {
            const QJsonObject found = json_of(identify(more))["resonator"].toObject();
            return found["angle_rate_rad_s"]["u"].toDouble();
        };
        const double none = uncertainty({"--tolerance", "delay=0"});
        const double usual = uncertainty({});
        const double known = uncertainty({"--f0", "5300"});
        const double large = uncertainty({"--f0", "5300", "--tolerance", "delay=1us"});
        VYBEG_MORE(usual, 1.2 * known);
        VYBEG_MORE(known, 1.2 * none);
        VYBEG_MORE(large, 20 * known);
        QVERIFY(!identify({"--f0", "5300"}).err.contains("has no effect"));
    }

    // As samples they would be two channels with an offset.
    void logs_are_no_recordings() {
        for (const QString columns : {"E,R,S,Q", "Xc,Yc,Xd,Yd", "a,b,theta"}) {
            QByteArray log = "t_s," + columns.toUtf8() + "\n";
            for (int k = 0; k < 400; ++k) {
                log += QByteArray::number(0.1 * k) + ",1,0.5,0.5";
                log += columns.startsWith('a') ? "\n" : ",0.1\n";
            }
            QVERIFY(put(path("log.csv"), log));
            for (const QString command : {"info", "identify"}) {
                const Outcome refused = run({command, "log.csv"});
                QCOMPARE(refused.status, 3);
                QVERIFY2(refused.err.contains("log.csv is a log, no recording"), refused.err);
                const QString hint =
                    columns.startsWith('X') ? QString("--phasors fixed") : "--columns " + columns;
                QVERIFY2(refused.err.contains(hint.toUtf8()), refused.err);
            }
        }
    }

    // Its numbers may be looked at.
    void a_track_is_no_recording_to_analyse() {
        QCOMPARE(run({"info", tracks_.front()}).status, 0);
        for (const QStringList& command :
             {QStringList{"identify"}, QStringList{"analyze", "-o", "-"}}) {
            const Outcome refused = run(command + QStringList{tracks_.front()});
            VYBEG_EQUAL(refused.status, 3, refused.err);
            QVERIFY2(refused.err.contains("--columns a,b,theta"), refused.err);
        }
    }

    void columns_and_models_that_cannot_be_are_refused() {
        QCOMPARE(run("identify 0.csv --columns E,R,S").status, 2);
        QCOMPARE(run("identify 0.csv --columns E,R,S,Q").status, 3);
        QCOMPARE(run("identify 0.csv 0.csv --columns a,b,theta").status, 4);
        QCOMPARE(run("identify 0.csv --columns a,b,theta --model free").status, 2);
    }

private:
    // Of a wave that decays and turns, with E in another unit and an offset of Q.
    void write_powers(const QString& name, double e_by, double q) const {
        QByteArray log = "t_s,E,R,S,Q\n";
        for (int k = 0; k < 400; ++k) {
            const double t = 0.1 * k;
            const double power = std::exp(-t / 10);
            const double turned = 0.4 + 0.01 * t;
            QList<QByteArray> fields;
            for (const double value :
                 {t, e_by * power, power * std::cos(turned), power * std::sin(turned), q}) {
                fields << QByteArray::number(value, 'g', 12);
            }
            log += fields.join(',') + '\n';
        }
        if (!put(path(name), log)) {
            qFatal("no file");
        }
    }

    QStringList recordings_;
    QStringList tracks_;
    QStringList packed_;
};

VYBEG_TEST(TestCliPowers)

}  // namespace test_cli_powers

#include "test_cli_powers.moc"
