// compare: a passport against new recordings, on simulated sets of which one is another
// resonator's.
#include "tests/app/resonator_runs.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

namespace test_cli_compare {

using namespace vybeg::test;

namespace {

const QStringList set = set_of("r");

QJsonObject named(const QJsonArray& list, const QString& name) {
    for (const QJsonValue& entry : list) {
        if (entry["name"] == name) {
            return entry.toObject();
        }
    }
    return {};
}

}  // namespace

class TestCliCompare : public QObject, private CliFolder {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(simulate_set(folder_.path(), "r", "1e-3", 1));
        QVERIFY(simulate_set(folder_.path(), "changed", "1.02e-3", 11));
        QVERIFY(simulate_set(folder_.path(), "same", "1e-3", 21));
        QVERIFY(simulate_still(folder_.path()));
        QCOMPARE(run("identify", set + words("--passport p.json")).status, 0);
        QVERIFY(put(path("not.json"), "{\"some\": 1}"));
        QVERIFY(put(path("no.json"), "{"));
        QVERIFY(put(path("newer.json"), "{\"vybeg\": \"passport\", \"schema\": 99}"));
        QVERIFY(put(path("part.json"), "{\"vybeg\": \"passport\", \"schema\": 2}"));
    }

    void a_passport_is_compared_parameter_by_parameter() {
        QCOMPARE(object(file("p.json"))["schema"].toInt(), 2);
        QCOMPARE(object(file("p.json"))["tracks"].toArray().size(), 4);

        const auto compared = [&](const QStringList& files) {
            const Outcome outcome = run("compare p.json", files + words("-o -"));
            return outcome.status == 0 ? object(outcome.out) : QJsonObject();
        };
        const QJsonObject itself = compared(set);
        VYBEG_MORE(itself["differences"].toArray().size(), 8);
        QCOMPARE(itself["passport"]["file"].toString(), QString("p.json"));
        for (const QJsonValue& difference : itself["differences"].toArray()) {
            QCOMPARE(difference["verdict"].toString(), QString("unchanged"));
            VYBEG_LESS(difference["deviations"].toDouble(), 1e-6);
        }
        const QJsonArray changed = compared(set_of("changed"))["differences"].toArray();
        const QJsonObject split = named(changed, "split_hz");
        QCOMPARE(split["verdict"].toString(), QString("changed"));
        VYBEG_MORE(split["deviations"].toDouble(), 3);
        VYBEG_LESS(deviations(split["change"], 2e-5), 4);
        QCOMPARE(named(changed, "tau_s")["verdict"].toString(), QString("unchanged"));
        QCOMPARE(named(changed, "theta_w_rad")["verdict"].toString(), QString("unchanged"));
        const QJsonArray same = compared(set_of("same"))["differences"].toArray();
        QCOMPARE(named(same, "split_hz")["verdict"].toString(), QString("unchanged"));
        VYBEG_MORE(named(same, "split_hz")["deviations"].toDouble(), 0);

        // One still recording does not know the split: not comparable, for its reason.
        const QJsonObject single =
            named(compared({"still.wav"})["differences"].toArray(), "split_hz");
        QCOMPARE(single["verdict"].toString(), QString("not comparable"));
        QVERIFY(single["now"]["reason"].toString().contains("recording that starts at"));
        const Outcome summary = run("compare p.json", set);
        QCOMPARE(summary.status, 0);
        QVERIFY(summary.out.contains("compared with p.json"));
        QVERIFY(summary.out.contains("unchanged"));
    }

    void another_gyro_s_passport_is_named() {
        const auto list = [&](const char* name, const char* gyro) {
            QByteArray rows = "file,gyro,date,bias_v\n";
            for (const QString& each : set) {
                rows += each.toUtf8() + "," + gyro + ",2026-03-31,60\n";
            }
            return put(path(name), "set," + rows.replace("\n", "\nS,").chopped(2));
        };
        QVERIFY(list("g1.csv", "HRG-1") && list("g2.csv", "HRG-2") && list("none.csv", ""));
        QCOMPARE(run("identify --list g1.csv --passport g1.json").status, 0);
        const QJsonObject passport = object(file("g1.json"));
        QCOMPARE(passport["gyro"].toString(), QString("HRG-1"));
        QCOMPARE(passport["date"].toString(), QString("2026-03-31"));
        QCOMPARE(passport["conditions"].toObject(), (QJsonObject{{"bias_v", "60"}}));
        const Outcome other = run("compare g1.json --list g2.csv -o -");
        QCOMPARE(other.status, 0);
        QVERIFY2(other.err.contains("HRG-1") && other.err.contains("HRG-2"), other.err);
        const QJsonObject warning = object(other.out)["warnings"][0].toObject();
        QCOMPARE(warning["kind"].toString(), QString("other-gyro"));
        QCOMPARE(warning["severity"].toString(), QString("serious"));
        QCOMPARE(warning["count"].toInt(), 1);
        for (const QString& lst : {QStringLiteral("g1.csv"), QStringLiteral("none.csv")}) {
            const Outcome same = run({"compare", "g1.json", "--list", lst, "-o", "-"});
            QCOMPARE(same.status, 0);
            QVERIFY2(!same.out.contains("other-gyro"), same.out);
        }
        const Outcome files = run("compare g1.json", set);
        QVERIFY(!files.err.contains("HRG-1"));
    }

    void kappa_in_the_passport_is_the_result_s() {
        const QStringList told = words("--kappa 1.25 --tolerance kappa=0.3");
        QCOMPARE(run("identify", set + told + words("-o k.json --passport kp.json")).status, 0);
        const QJsonObject result = object(file("k.json"));
        const QJsonObject passport = object(file("kp.json"));
        const QJsonValue kappa = result["resonator"]["kappa"];
        QVERIFY2(kappa["value"].isDouble(), qPrintable(kappa["reason"].toString()));
        VYBEG_LESS(deviations(kappa, 1), 4);
        QCOMPARE(passport["resonator"]["kappa"]["value"], kappa["value"]);
        QCOMPARE(passport["resonator"]["kappa"]["sd"], kappa["sd"]);
        const QJsonObject raw = passport["parameters"].toObject();
        const QJsonArray names = raw["names"].toArray();
        for (qsizetype k = 0; k < names.size(); ++k) {
            if (names[k] == "kappa") {
                const double value = raw["values"][k].toDouble();
                const double variance = raw["covariance"][k * names.size() + k].toDouble();
                VYBEG_CLOSE(value, kappa["value"].toDouble(), 1e-12);
                // The covariance is that of the fit: u holds assumed tolerances besides.
                VYBEG_CLOSE_RATIO(std::sqrt(variance), kappa["sd"].toDouble(), 2e-3);
                return;
            }
        }
        QFAIL("the passport's parameters hold no kappa");
    }

    void frequencies_change_beyond_a_limit() {
        const auto split_of = [&](const QStringList& more, const QString& name) {
            const Outcome outcome =
                run("compare p.json --f0 5300.1", set_of("same") + words("-o -") + more);
            return named(object(outcome.out)["differences"].toArray(), name);
        };
        const QJsonObject usual = split_of({}, "f_mean_hz");
        QCOMPARE(usual["verdict"].toString(), QString("unchanged"));
        VYBEG_CLOSE_RATIO(usual["limit"].toDouble(), 30e-6 * 5300, 1e-3);
        QVERIFY(usual["relative"].isDouble());
        VYBEG_MORE(usual["change"]["u"].toDouble(), usual["change"]["sd"].toDouble());
        QVERIFY(!split_of({}, "split_hz").contains("limit"));
        const QJsonObject wide = split_of({"--f-limit", "50"}, "f_mean_hz");
        VYBEG_CLOSE_RATIO(wide["limit"].toDouble(), 50e-6 * 5300, 1e-3);
    }

    void a_failure_has_its_status_and_one_sentence_data() {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* name, const QString& arguments, int status,
                            const QString& part) {
            QTest::newRow(name) << arguments << status << part;
        };
        row("result over the passport", "compare p.json r0.wav -o p.json", 2, "to compare with");
        row("compare without a recording", "compare p.json", 2, "FILE");
        row("negative limit", "compare p.json r0.wav --f-limit -1", 2, "negative");
        row("limit of nothing", "compare p.json r0.wav --f-limit x", 2, "number");
        row("unknown tolerance", "compare p.json r0.wav --tolerance tilt=1", 2, "\"tilt\"");
        row("no passport there", "compare none.json r0.wav", 3, "no such file");
        row("another JSON", "compare not.json r0.wav", 3, "not a passport");
        row("no JSON", "compare no.json r0.wav", 3, "no JSON");
        row("newer passport", "compare newer.json r0.wav", 3, "schema 99");
        row("part of a passport", "compare part.json r0.wav", 3, "program");
    }

    void a_failure_has_its_status_and_one_sentence() {
        QFETCH(QString, arguments);
        QFETCH(int, status);
        QFETCH(QString, part);
        QCOMPARE(fault_of(run(arguments), status, part), QString());
        QCOMPARE(temporaries(), QStringList());
    }
};

VYBEG_TEST(TestCliCompare)

}  // namespace test_cli_compare

#include "test_cli_compare.moc"
