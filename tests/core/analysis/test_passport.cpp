// What a comparison says of parameters that moved, did not, or are not known.
#include "core/analysis/passport.h"
#include "core/base/diagnostic.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <numbers>

namespace test_passport {

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

RunEstimate unknown_run() {
    RunEstimate run;
    for (Estimate* each :
         {&run.f_offset_hz, &run.a_A, &run.a_B, &run.two_theta_A_rad, &run.split_sin_hz,
          &run.direction_f_hz, &run.direction_tau_s, &run.q_envelope, &run.drift_hz_per_s}) {
        each->reason = unknown;
    }
    return run;
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
        VYBEG_CLOSE(difference.deviations(), std::abs(now - 1e-4) / 5e-6, 1e-9);
    }

    void axes_differ_by_the_shorter_way() {
        Pair pair = pair_of();
        const double quarter = std::numbers::pi / 4;
        pair.then.resonator.theta_w_rad = {quarter - 0.01, 0.003, {}};
        pair.now.resonator.theta_w_rad = {-quarter + 0.005, 0.004, {}};
        const Difference difference = only(pair);
        VYBEG_CLOSE(difference.change, 0.015, 1e-12);
        if (difference.verdict != Verdict::changed) {
            VYBEG_LESS(difference.deviations(), 3.0001);
        }
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

    void a_size_beyond_the_bound_of_the_other_side_has_changed_data() {
        QTest::addColumn<double>("size");
        QTest::addColumn<double>("limit");
        QTest::addColumn<bool>("changed");
        // The bound has three digits: 2e-5 stands for up to 2.01e-5.
        QTest::newRow("a balanced split") << 1e-3 << 0.0 << true;
        QTest::newRow("three deviations above") << 2.311e-5 << 0.0 << true;
        QTest::newRow("less than three above") << 2.309e-5 << 0.0 << false;
        QTest::newRow("below the bound") << 1e-5 << 0.0 << false;
        QTest::newRow("too little to matter") << 1e-3 << 9.9e-4 << false;
        QTest::newRow("enough to matter") << 1e-3 << 9.7e-4 << true;
    }

    void a_size_beyond_the_bound_of_the_other_side_has_changed() {
        QFETCH(double, size);
        QFETCH(double, limit);
        QFETCH(bool, changed);
        const Estimate bound{
            .reason = {ReasonCode::within_noise, {number_arg(2e-5, 3), unit_arg("Hz")}}};
        for (const bool bound_now : {true, false}) {
            Pair pair = pair_of();
            pair.then.resonator.split_hz = pair.now.resonator.split_hz = {size, 1e-6, {}};
            // An axis whose size is within its noise says nothing about the other side's axis.
            pair.then.resonator.theta_w_rad = pair.now.resonator.theta_w_rad = {0.7, 1e-3, {}};
            ResonatorEstimate& bounded = bound_now ? pair.now.resonator : pair.then.resonator;
            bounded.split_hz = bounded.theta_w_rad = bound;
            const std::vector<Difference> differences =
                compare(pair.then, pair.now, {.limits = {{"split_hz", limit, false}}});
            QCOMPARE(differences.size(), std::size_t{2});
            for (const Difference& each : differences) {
                const bool is_size = each.name == "split_hz";
                QVERIFY(each.verdict ==
                        (changed && is_size ? Verdict::changed : Verdict::not_comparable));
                QVERIFY(!each.known());
                QVERIFY(each.why ==
                        (bound_now ? Incomparable::now_unknown : Incomparable::then_unknown));
            }
        }
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

    void modes_named_by_different_things_are_not_comparable() {
        Pair pair = pair_of();
        ModeEstimate mode;
        mode.f_hz = {5300, 1e-6, {}};
        mode.tau_s = {400, 0.01, {}};
        mode.q = {6e6, 150, {}};
        pair.then.modes = {mode, mode};
        pair.now.modes = {mode, mode};
        pair.now.modes[0].tau_s.value = 410;
        pair.then.mode_order = ModeOrder::decay;
        const std::vector<Difference> differences = compare(pair.then, pair.now);
        QCOMPARE(differences.size(), std::size_t{6});
        for (const Difference& difference : differences) {
            QVERIFY(difference.verdict == Verdict::not_comparable);
            QVERIFY(difference.why == Incomparable::other_mode_order);
        }
        pair.then.mode_order = pair.now.mode_order = ModeOrder::decay;
        QVERIFY(compare(pair.then, pair.now)[1].verdict == Verdict::changed);
    }

    void a_frequency_changes_beyond_its_limit_and_the_spread_of_the_runs() {
        Pair pair = pair_of();
        pair.then.resonator.f_mean_hz = {5300, 4e-8, {}};
        pair.now.resonator.f_mean_hz = {5300.1, 4e-8, {}};
        // 0.1 Hz of temperature, 19 ppm, was "changed by 2.8 million deviations".
        QVERIFY(only(pair).verdict == Verdict::unchanged);
        VYBEG_CLOSE(only(pair).relative, 0.1 / 5300, 1e-12);
        VYBEG_CLOSE(only(pair).limit, 30e-6 * 5300, 1e-12);
        QVERIFY(compare(pair.then, pair.now, {.f_limit_ppm = 18})[0].verdict == Verdict::changed);
        pair.now.resonator.f_mean_hz.value = 5300.2;
        QVERIFY(only(pair).verdict == Verdict::changed);
        // Runs that scatter by 0.1 Hz do not tell 0.2 Hz.
        RunEstimate run = unknown_run();
        run.f_offset_hz = {0.1, 1e-7, {}};
        pair.now.runs = {run, run};
        pair.now.runs[1].f_offset_hz.value = -0.1;
        const Difference scattered = only(pair);
        QVERIFY(scattered.verdict == Verdict::unchanged);
        VYBEG_CLOSE(scattered.u, std::sqrt(0.02), 1e-9);
        VYBEG_LESS(scattered.sd, 1e-6);
    }

    // A temperature moves f by 20 ppm, within its limit, and Q with it, by 20 of its deviations.
    void q_is_not_changed_where_only_a_frequency_within_its_limit_moves() {
        Pair pair = pair_of();
        pair.then.resonator.f_mean_hz = {5300, 1e-7, {}};
        pair.now.resonator.f_mean_hz = {5300 * (1 + 20e-6), 1e-7, {}};
        pair.then.resonator.tau_s = pair.now.resonator.tau_s = {400, 4e-4, {}};
        pair.then.resonator.q = {6.66e6, 6.66, {}};
        pair.now.resonator.q = {6.66e6 * (1 + 20e-6), 6.66, {}};
        const std::vector<Difference> moved = compare(pair.then, pair.now);
        QCOMPARE(moved.size(), std::size_t(3));
        for (const Difference& each : moved) {
            QCOMPARE(each.verdict, Verdict::unchanged);
            QCOMPARE(each.follows, each.name == "q");
        }
        QCOMPARE(count_compared(moved), std::size_t(2));
        // With the decay time it has changed, too.
        pair.now.resonator.tau_s.value = 400.1;
        pair.now.resonator.q.value = 6.66e6 * (1 + 20e-6 + 2.5e-4);
        const std::vector<Difference> changed = compare(pair.then, pair.now);
        for (const Difference& each : changed) {
            QCOMPARE(each.verdict == Verdict::changed, each.name != "f_mean_hz");
        }
        // Without a decay time, Q has the limit of the frequency.
        pair.now.resonator.tau_s = {.reason = unknown};
        pair.now.resonator.q.value = 6.66e6 * (1 + 20e-6);
        for (const Difference& each : compare(pair.then, pair.now)) {
            QVERIFY(each.verdict != Verdict::changed);
        }
    }

    void a_passport_of_another_gyro_is_named() {
        Passport passport;
        QVERIFY(!other_gyro(passport, "HRG-2"));
        passport.gyro = "HRG-1";
        QVERIFY(!other_gyro(passport, ""));
        QVERIFY(!other_gyro(passport, "HRG-1"));
        const auto other = other_gyro(passport, "HRG-2");
        QVERIFY(other && severity(other->kind) == Severity::serious);
        const QString text = QString::fromStdString(english(*other));
        QVERIFY(text.contains("HRG-1") && text.contains("HRG-2"));
    }

    void tolerances_of_the_channels_count() {
        Pair pair = pair_of();
        pair.then.resonator.tau_s = {400, 0.001, {}, 0.1};
        pair.now.resonator.tau_s = {400.2, 0.001, {}};
        const Difference difference = only(pair);
        QVERIFY(difference.verdict == Verdict::unchanged);
        QCOMPARE(difference.u, std::hypot(0.1, 0.001));
        QCOMPARE(difference.sd, std::hypot(0.001, 0.001));
        VYBEG_CLOSE(difference.relative, 0.2 / 400, 1e-12);
    }

    void many_parameters_need_more_deviations_each() {
        QCOMPARE(changed_from(0), 3.0);
        QCOMPARE(changed_from(1), 3.0);
        for (const std::size_t count : {2, 12, 40}) {
            const double z = changed_from(count);
            const double all = 1 - std::pow(std::erf(z / std::sqrt(2)), double(count));
            VYBEG_CLOSE_RATIO(all, 0.0026998, 1e-3, qPrintable(QString::number(z)));
        }
    }

    void a_direction_is_compared_with_the_same_direction_alone_data() {
        QTest::addColumn<double>("two_theta");
        QTest::addColumn<bool>("comparable");
        QTest::addColumn<bool>("changed");
        const double pi = std::numbers::pi;
        QTest::newRow("the same") << 0.3 << true << true;
        QTest::newRow("1e-4 rad on") << 0.3001 << true << true;
        // An unseen anisotropy may make 9 % of it.
        QTest::newRow("0.09 rad on") << 0.39 << true << false;
        QTest::newRow("modulo pi") << 0.3 - pi << true << true;
        QTest::newRow("modulo pi, the other way") << 0.25 + pi << true << false;
        QTest::newRow("0.11 rad on") << 0.41 << false << false;
        QTest::newRow("30 degrees on") << 0.3 + pi / 3 << false << false;
    }

    // f and tau of one direction were called the resonator's: 1700 deviations between two starts.
    void a_direction_is_compared_with_the_same_direction_alone() {
        QFETCH(double, two_theta);
        QFETCH(bool, comparable);
        QFETCH(bool, changed);
        Pair pair = pair_of();
        RunEstimate run = unknown_run();
        run.two_theta_A_rad = {0.3, 1e-4, {}};
        run.direction_f_hz = {5300, 1e-6, {}};
        run.direction_tau_s = {400, 0.01, {}};
        RunEstimate other = run;
        other.two_theta_A_rad.value = 1.9;
        pair.then.runs = {other, run};
        run.two_theta_A_rad.value = two_theta;
        run.direction_tau_s.value = 401;
        pair.now.runs = {run};
        const std::vector<Difference> differences = compare(pair.then, pair.now);
        QCOMPARE(differences.size(), std::size_t{2});
        QCOMPARE(differences[0].name, std::string("runs[0].direction.f_hz"));
        QCOMPARE(differences[1].name, std::string("runs[0].direction.tau_s"));
        const Verdict known = changed ? Verdict::changed : Verdict::unchanged;
        const Verdict wanted[] = {comparable ? Verdict::unchanged : Verdict::not_comparable,
                                  comparable ? known : Verdict::not_comparable};
        for (std::size_t k = 0; k < 2; ++k) {
            QVERIFY(differences[k].verdict == wanted[k]);
            QVERIFY(comparable || differences[k].why == Incomparable::other_direction);
        }
        // Where the resonator's own are known, they are compared instead.
        pair.then.resonator.f_mean_hz = pair.now.resonator.f_mean_hz = {5300, 1e-6, {}};
        pair.then.resonator.tau_s = pair.now.resonator.tau_s = {400, 0.1, {}};
        QCOMPARE(compare(pair.then, pair.now).size(), std::size_t{2});
        QCOMPARE(compare(pair.then, pair.now)[0].name, std::string("f_mean_hz"));
    }

    void a_part_of_nothing_is_not_stated() {
        Pair pair = pair_of();
        pair.then.resonator.angle_rate_rad_s = {1e-9, 1e-8, {}};
        pair.now.resonator.angle_rate_rad_s = {1e-6, 1e-8, {}};
        QVERIFY(only(pair).verdict == Verdict::changed);
        QVERIFY(std::isnan(only(pair).relative));
        Pair axes = pair_of();
        axes.then.resonator.theta_w_rad = {0.2, 1e-4, {}};
        axes.now.resonator.theta_w_rad = {0.3, 1e-4, {}};
        QVERIFY(std::isnan(only(axes).relative));
    }
};

VYBEG_TEST(TestPassport)

}  // namespace test_passport

#include "test_passport.moc"
