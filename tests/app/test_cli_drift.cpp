// vybeg-cli drift as a process.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QtTest>

#include <cmath>
#include <numbers>

namespace test_cli_drift {

using namespace vybeg::test;

namespace {

// A wave that turns by 0.05 rad/s with c4 = 3e-4 rad/s, by small steps, with the digits of the file
// as noise.
QString written(const QString& path, const QString& header, double per_rad, double c4 = 3e-4) {
    QByteArray log = header.toUtf8();
    double theta = 0.1;
    for (int k = 0; k < 3000; ++k) {
        log += QByteArray::number(0.1 * k, 'f', 1) + "," +
               QByteArray::number(per_rad * theta, 'f', 5) + "\n";
        for (int part = 0; part < 20; ++part) {
            const double middle = theta + 0.0025 * (0.05 + c4 * std::cos(4 * theta));
            theta += 0.005 * (0.05 + c4 * std::cos(4 * middle));
        }
    }
    if (!put(path, log)) {
        qFatal("no file");
    }
    return path;
}

}  // namespace

class TestCliDrift : public QObject, private CliFolder {
    Q_OBJECT

private slots:
    void degrees_and_radians_give_one_drift() {
        const double degrees = 180 / std::numbers::pi;
        const double deg_h = 3600 * degrees;
        for (const QString& log :
             {written(path("deg.csv"), "t_s,theta_deg\n", degrees),
              written(path("rad.csv"), "t,theta [rad]\n", 1), written(path("plain.csv"), "", 1)}) {
            QStringList arguments{"drift", log, "--json"};
            if (log.endsWith("plain.csv")) {
                arguments << "--angle-unit"
                          << "rad";
            }
            const Outcome outcome = run(arguments);
            QCOMPARE(outcome.status, 0);
            const QJsonObject harmonics = json_of(outcome)["harmonics"].toObject();
            VYBEG_CLOSE(harmonics["mean_deg_h"]["value"].toDouble(), 0.05 * deg_h, 0.01);
            const QJsonObject cos4 = harmonics["cos4_deg_h"].toObject();
            VYBEG_LESS(std::abs(cos4["value"].toDouble() - 3e-4 * deg_h) / cos4["sd"].toDouble(),
                       4.5);
            QCOMPARE(json_of(outcome)["bins"].toArray().size(), 36);
            QCOMPARE(json_of(outcome)["covariance_deg_h2"].toArray().size(), 5);
        }
    }

    void a_column_of_angles_alone_takes_the_rate_of_the_option() {
        QFile both(written(path("both.csv"), "", 1));
        QFile alone(path("alone.csv"));
        QVERIFY(both.open(QIODevice::ReadOnly) && alone.open(QIODevice::WriteOnly));
        while (!both.atEnd()) {
            alone.write(both.readLine().split(',').last());
        }
        alone.close();
        const Outcome outcome = run("drift alone.csv --rate 10Hz --angle-unit rad --json");
        QCOMPARE(outcome.status, 0);
        const double deg_h = 3600 * 180 / std::numbers::pi;
        const QJsonObject harmonics = json_of(outcome)["harmonics"].toObject();
        VYBEG_CLOSE(harmonics["mean_deg_h"]["value"].toDouble(), 0.05 * deg_h, 0.01);
        const Outcome named = run("drift alone.csv --rate 10 --columns theta=psi");
        QVERIFY2(named.err.contains("there is no column \"psi\"; the file has 1."), named.err);
    }

    void columns_are_named_and_units_asked_for() {
        const QString log = written(path("log.csv"), "t,psi\n", 1);
        const Outcome unnamed = run({"drift", log});
        QCOMPARE(unnamed.status, 3);
        QVERIFY(unnamed.err.contains("there is no column \"theta\"; the file has t, psi."));
        const Outcome unit = run({"drift", log, "--columns", "t,theta=psi"});
        QCOMPARE(unit.status, 3);
        QVERIFY(unit.err.contains("--angle-unit"));
        QCOMPARE(run({"drift", log, "--columns", "t,theta=2", "--angle-unit", "rad"}).status, 0);
        QCOMPARE(run({"drift", log, "--columns", "t,phi"}).status, 2);
        QCOMPARE(run({"drift", log, "--columns", "t"}).status, 2);
        const Outcome twice = run({"drift", log, "--columns", "t,theta=psi,theta=2"});
        QCOMPARE(twice.status, 2);
        QVERIFY2(twice.err.contains("theta is named twice"), twice.err);
    }

    void logs_that_differ_are_told_so() {
        const QString one = written(path("a.csv"), "t,theta_rad\n", 1);
        const QString other = written(path("b.csv"), "t,theta_rad\n", 1, 3.5e-4);
        const Outcome outcome = run({"drift", one, other, "--json"});
        QCOMPARE(outcome.status, 0);
        QVERIFY(outcome.err.contains("The logs differ in the harmonic 4 of the drift"));
        const QJsonObject found = json_of(outcome);
        QVERIFY(found["harmonics"]["cos4_deg_h"]["value"].isNull());
        QCOMPARE(found["agreement"][2]["agrees"], QJsonValue(false));
    }

    void bins_are_a_table_and_outputs_do_not_meet() {
        const QString log = written(path("log.csv"), "t,theta_rad\n", 1);
        const Outcome table = run({"drift", log, "-o", "-"});
        QCOMPARE(table.status, 0);
        QVERIFY(table.out.contains(
            "\ntheta_deg,rate_deg_h,sd_rate_deg_h,curve_deg_h,sd_curve_deg_h,seconds\n2.5,"));
        QCOMPARE(run({"drift", log, "-o", log}).status, 2);
        QCOMPARE(run({"drift", log, "-o", "-", "--json"}).status, 2);
        QCOMPARE(run({"drift", log, "-o", path("x.txt")}).status, 5);
        const QString json = path("x.json");
        const Outcome summary = run({"drift", log, "-o", json});
        QCOMPARE(summary.status, 0);
        QVERIFY(summary.out.contains("drift, d theta_A/dt"));
        QVERIFY(QFile::exists(json));
        // With what the numbers were found, in both files.
        const Outcome told =
            run({"drift", log, "--json", "--tolerance", "skew=0.2", "--rate", "7"});
        const QJsonObject settings = json_of(told)["settings"].toObject();
        QCOMPARE(settings["tolerance"].toString(), QString("kappa=0.01,skew=0.2"));
        QCOMPARE(settings["rate"].toString(), QString("7"));
        QVERIFY2(table.out.contains("\n# tolerance: kappa=0.01,skew=0.1\n"), table.out);
    }
};

VYBEG_TEST(TestCliDrift)

}  // namespace test_cli_drift

#include "test_cli_drift.moc"
