// What a comparison says of parameters that moved, did not, or are not known.
#include "core/resonator/passport.h"

#include <QtTest>

#include <cmath>
#include <numbers>

using namespace vybeg;

namespace {

const Reason unknown{ReasonCode::one_direction, {"22.5", "28"}};

ResonatorEstimate all_unknown() {
    ResonatorEstimate resonator;
    for (Estimate* estimate :
         {&resonator.f_mean_hz, &resonator.split_hz, &resonator.theta_w_rad, &resonator.tau_s,
          &resonator.q, &resonator.damping_anisotropy_per_s, &resonator.theta_tau_rad,
          &resonator.angle_rate_rad_s, &resonator.kappa, &resonator.non_orthogonality_rad,
          &resonator.delay_s, &resonator.frequency_per_power}) {
        estimate->reason = unknown;
    }
    return resonator;
}

struct Pair {
    Passport then;
    ResonatorFit now;
};

Pair pair_of() {
    Pair pair;
    pair.then.resonator = all_unknown();
    pair.now.resonator = all_unknown();
    return pair;
}

Difference only(const Pair& pair) {
    const std::vector<Difference> differences = compare(pair.then, pair.now);
    return differences.size() == 1 ? differences[0] : Difference{"none", "", {}, {}};
}

}  // namespace

class TestPassport : public QObject {
    Q_OBJECT

private slots:
    void a_parameter_has_changed_from_three_deviations_on_data() {
        QTest::addColumn<double>("now");
        QTest::addColumn<bool>("changed");
        QTest::newRow("equal") << 1e-4 << false;
        QTest::newRow("below") << 1.149e-4 << false;
        QTest::newRow("above") << 1.151e-4 << true;
        QTest::newRow("above, downwards") << 0.849e-4 << true;
    }

    void a_parameter_has_changed_from_three_deviations_on() {
        QFETCH(double, now);
        QFETCH(bool, changed);
        Pair pair = pair_of();
        pair.then.resonator.split_hz = {1e-4, 3e-6, {}};
        pair.now.resonator.split_hz = {now, 4e-6, {}};
        const Difference difference = only(pair);
        QCOMPARE(difference.name, std::string("split_hz"));
        QCOMPARE(difference.verdict == Verdict::changed, changed);
        QCOMPARE(difference.sd, 5e-6);
        QCOMPARE(difference.change, now - 1e-4);
        QVERIFY(std::abs(difference.deviations() - std::abs(now - 1e-4) / 5e-6) < 1e-9);
    }

    void axes_differ_by_the_shorter_way() {
        Pair pair = pair_of();
        const double quarter = std::numbers::pi / 4;
        pair.then.resonator.theta_w_rad = {quarter - 0.01, 0.003, {}};
        pair.now.resonator.theta_w_rad = {-quarter + 0.005, 0.004, {}};
        const Difference difference = only(pair);
        QVERIFY(std::abs(difference.change - 0.015) < 1e-12);
        QVERIFY(difference.verdict == Verdict::changed || difference.deviations() < 3.0001);
        pair.now.resonator.theta_w_rad.value = -quarter;
        QVERIFY(only(pair).verdict == Verdict::unchanged);
    }

    void what_one_side_does_not_know_is_not_comparable() {
        Pair pair = pair_of();
        pair.then.resonator.kappa = {1, 1e-4, {}};
        const Difference difference = only(pair);
        QVERIFY(difference.verdict == Verdict::not_comparable);
        QVERIFY(difference.now.reason == unknown);
        QVERIFY(std::isnan(difference.change));
        QVERIFY(compare(pair_of().then, pair_of().now).empty());
    }

    void modes_are_compared_one_by_one() {
        Pair pair = pair_of();
        ModeEstimate mode;
        mode.f_hz = {1020, 0.01, {}};
        mode.tau_s = {0.8, 0.01, {}};
        mode.q = {2600, 30, {}};
        pair.then.modes = {mode, mode};
        mode.f_hz.value = 1020.1;
        pair.now.modes = {mode};
        const std::vector<Difference> differences = compare(pair.then, pair.now);
        QCOMPARE(differences.size(), std::size_t{6});
        QCOMPARE(differences[0].name, std::string("modes[0].f_hz"));
        QVERIFY(differences[0].verdict == Verdict::changed);
        QVERIFY(differences[1].verdict == Verdict::unchanged);
        QCOMPARE(differences[3].name, std::string("modes[1].f_hz"));
        QVERIFY(differences[3].verdict == Verdict::not_comparable);
        QVERIFY(differences[3].now.reason.code == ReasonCode::modes_not_apart);
    }
};

QTEST_GUILESS_MAIN(TestPassport)
#include "test_passport.moc"
