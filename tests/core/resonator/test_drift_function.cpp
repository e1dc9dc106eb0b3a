// The drift function against the equations of motion.
//
// Statistical model: the coefficients' errors are Gaussian with the covariance told; each is held
// to four and a half of its deviations, and over many seeds their squares in units of it to their
// mean of one.
#include "core/resonator/model/slow_dynamics.h"
#include "core/resonator/results/drift_function.h"
#include "core/resonator/results/resonator_fit.h"
#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <numbers>

namespace test_drift_function {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr double pi = std::numbers::pi;

FreeDecay gyro() {
    FreeDecay decay{.split_hz = 1e-4,
                    .theta_w = 0.2,
                    .tau_s = 400,
                    .damping_anisotropy_per_s = 3e-4,
                    .theta_tau = -0.3,
                    .omega_rad_s = 2e-5,
                    .noise = 1e-3};
    return decay;
}

// Standing waves at `starts` degrees of theta_A.
std::vector<PhasorRun> set_of(FreeDecay decay, const std::vector<double>& starts,
                              std::uint64_t seed) {
    std::vector<PhasorRun> runs;
    for (const double start : starts) {
        decay.two_theta_A = 2 * start * pi / 180;
        runs.push_back(simulated_phasors(decay, 500, seed * 100 + runs.size()));
    }
    return runs;
}

// By the resonator's fit of the same runs.
DriftFunction drift_of(const std::vector<PhasorRun>& runs, const FitOptions& options = {}) {
    const Result<ResonatorFit> fit = fit_resonator(runs, options, {});
    if (!fit || fit->model != ResonatorModel::structured) {
        qFatal("no structured fit");
    }
    return drift_function(runs, *fit);
}

// m, c4, s4 as METHOD section 8 has them.
Eigen::Vector3d truth_of(const FreeDecay& decay) {
    const double quarter = decay.damping_anisotropy_per_s / 4;
    return {-decay.bryan * decay.omega_rad_s, -quarter * std::sin(4 * decay.theta_tau),
            quarter * std::cos(4 * decay.theta_tau)};
}

double worst_deviation(const DriftFunction& found, const Eigen::Vector3d& truth) {
    double worst = 0;
    for (Eigen::Index k = 0; k < found.coefficients.size(); ++k) {
        const double expected = k < 3 ? truth[k] : 0;
        worst = largest_of({worst, std::abs(found.coefficients[k] - expected) /
                                       std::sqrt(found.covariance(k, k))});
    }
    return worst;
}

const std::vector<double> four_starts{0, 22.5, 45, 67.5};

}  // namespace

class TestDriftFunction : public QObject {
    Q_OBJECT

private slots:
    void a_set_of_four_angles_gives_the_fourth_harmonic_and_no_eighth() {
        const FreeDecay decay = gyro();
        const DriftFunction found = drift_of(set_of(decay, four_starts, 1));
        QCOMPARE(found.order, 4);
        QCOMPARE(found.coefficients.size(), Eigen::Index{3});
        VYBEG_CLOSE(worst_deviation(found, truth_of(decay)), 0, 4.5);
        VYBEG_LESS(std::sqrt(found.covariance(1, 1)), 0.01 * decay.damping_anisotropy_per_s);
        VYBEG_CLOSE(found.chi2_per_freedom, 1, 0.1);
        QCOMPARE(found.points.size(), std::size_t{4});
        for (const DriftPoint& point : found.points) {
            const double off = point.rate - found.rate(point.theta);
            const double sd = std::hypot(point.sd_rate, found.sd_rate(point.theta));
            VYBEG_CLOSE(off, 0, 5 * sd);
            VYBEG_MORE(point.sd_rate, 0);
            VYBEG_LESS(point.sd_rate, 1e-7);
        }
    }

    void what_a_split_does_through_the_quadrature_is_not_in_the_points() {
        FreeDecay decay = gyro();
        decay.split_hz = 0.003;
        const DriftFunction found = drift_of(set_of(decay, four_starts, 3));
        QCOMPARE(found.order, 4);
        QCOMPARE(found.points.size(), std::size_t{4});
        for (const DriftPoint& point : found.points) {
            // The quadrature turns them by some 1e-3 rad/s.
            const double sd = std::hypot(point.sd_rate, found.sd_rate(point.theta));
            VYBEG_LESS(sd, 1e-6);
            VYBEG_CLOSE(point.rate, found.rate(point.theta), 5 * sd);
        }
    }

    void six_angles_show_that_there_is_no_eighth_harmonic() {
        const FreeDecay decay = gyro();
        const DriftFunction found = drift_of(set_of(decay, {0, 15, 30, 45, 60, 75}, 2));
        QCOMPARE(found.order, 8);
        VYBEG_CLOSE(worst_deviation(found, truth_of(decay)), 0, 4.5);
    }

    void a_wave_that_turns_shows_its_drift_function_alone() {
        FreeDecay decay = gyro();
        decay.omega_rad_s = 0.3;  // through 133 degrees of theta_A
        // A gain ratio that is not told looks like an anisotropy in one turning wave.
        QCOMPARE(drift_of(set_of(decay, {10}, 3)).order, 0);
        const DriftFunction found = drift_of(set_of(decay, {10}, 3), {.tolerance = {}});
        VYBEG_AT_LEAST(found.order, 4);
        VYBEG_CLOSE(worst_deviation(found, truth_of(decay)), 0, 4.5);
        VYBEG_MORE(found.points.size(), 20);
    }

    void deviations_are_those_of_the_scatter() {
        const FreeDecay decay = gyro();
        const Eigen::Vector3d truth = truth_of(decay);
        constexpr int seeds = 60;
        Eigen::Vector3d squares = Eigen::Vector3d::Zero();
        for (int seed = 0; seed < seeds; ++seed) {
            const DriftFunction found =
                drift_of(set_of(decay, four_starts, static_cast<std::uint64_t>(10 + seed)));
            QCOMPARE(found.order, 4);
            for (int k = 0; k < 3; ++k) {
                squares[k] +=
                    std::pow(found.coefficients[k] - truth[k], 2) / found.covariance(k, k) / seeds;
            }
        }
        // The mean of 60 squares has a deviation of sqrt(2/60) = 0.18.
        for (int k = 0; k < 3; ++k) {
            VYBEG_CLOSE(squares[k], 1, 4 * std::sqrt(2.0 / seeds), qPrintable(QString::number(k)));
        }
    }

    // The eighth harmonic that channels of another gain ratio make was told with the deviation of
    // the noise alone.
    void channels_within_their_tolerances_are_in_u() {
        Eigen::Matrix<double, 5, 1> squares = Eigen::Matrix<double, 5, 1>::Zero();
        constexpr int sets = 40;
        int given = 0;
        int within = 0;
        for (std::uint64_t seed = 1; seed <= sets; ++seed) {
            FreeDecay decay = gyro();
            decay.noise = 1e-4;
            decay.split_hz = seed % 2 == 0 ? 1e-4 : 0.01;
            std::vector<PhasorRun> runs =
                set_of(decay, {0, 15, 30, 45, 60, 75}, static_cast<std::uint64_t>(500 + seed));
            spoil(runs, drawn_from(assuming.assumed, seed));
            const DriftFunction found = drift_of(runs, assuming);
            if (found.order < 8) {
                continue;
            }
            ++given;
            const Eigen::Vector3d truth = truth_of(decay);
            for (int k = 0; k < 5; ++k) {
                const double off = found.coefficients[k] - (k < 3 ? truth[k] : 0);
                const double pull = off / found.coefficient(k).uncertainty();
                squares[k] += pull * pull;
                within += std::abs(pull) < 2 ? 1 : 0;
            }
        }
        VYBEG_AT_LEAST(given, sets * 0.9);
        VYBEG_AT_LEAST(within, 5 * given * 0.9);
        for (int k = 0; k < 5; ++k) {
            VYBEG_AT_MOST(squares[k] / given, 1.5, qPrintable(QString::number(k)));
        }
    }

    // D of one recording has the other sign: the curve is that of the others, wherever it stands.
    void a_recording_that_is_left_out_has_no_part() {
        const std::vector<double> starts{0, 15, 30, 45, 60, 75};
        for (std::size_t out = 0; out < starts.size(); ++out) {
            std::vector<PhasorRun> runs = set_of(gyro(), starts, 700);
            for (auto& d : runs[out].d) {
                d = -d;
            }
            const Result<ResonatorFit> fit = fit_resonator(runs, assuming, {});
            QVERIFY(fit && fit->left_out == out);
            const DriftFunction found = drift_function(runs, *fit);
            runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(out));
            const DriftFunction expected = drift_of(runs, assuming);
            QCOMPARE(found.order, expected.order);
            for (Eigen::Index k = 0; k < expected.coefficients.size(); ++k) {
                VYBEG_CLOSE(found.coefficients[k], expected.coefficients[k],
                            1e-6 * expected.coefficient(k).sd);
                VYBEG_CLOSE_RATIO(found.coefficient(k).uncertainty(),
                                  expected.coefficient(k).uncertainty(), 1e-6);
            }
        }
    }

    void a_gap_takes_nothing_but_its_windows() {
        const FreeDecay decay = gyro();
        std::vector<PhasorRun> runs = set_of(decay, four_starts, 4);
        for (PhasorRun& run : runs) {
            const auto cut = [](auto& list) { list.erase(list.begin() + 500, list.begin() + 700); };
            cut(run.time_s);
            cut(run.c);
            cut(run.d);
            cut(run.sd);
        }
        const DriftFunction found = drift_of(runs);
        QCOMPARE(found.order, 4);
        QCOMPARE(found.points.size(), std::size_t{8});
        VYBEG_CLOSE(worst_deviation(found, truth_of(decay)), 0, 4.5);
    }

    void too_few_angles_leave_the_curve_unknown_data() {
        QTest::addColumn<QList<double>>("starts");
        QTest::newRow("one") << QList<double>{10};
    }

    void too_few_angles_leave_the_curve_unknown() {
        QFETCH(QList<double>, starts);
        const DriftFunction found = drift_of(set_of(gyro(), {starts.begin(), starts.end()}, 5));
        QCOMPARE(found.order, 0);
        QCOMPARE(found.coefficients.size(), Eigen::Index{0});
        // The turn by the quadrature, which no single recording tells from the drift, would stand
        // in a point with the deviation of the noise.
        QVERIFY(found.points.empty());
    }

    void one_angle_four_times_shows_no_more_than_it_can() {
        const FreeDecay decay = gyro();
        for (std::uint64_t seed = 5; seed < 10; ++seed) {
            const DriftFunction found = drift_of(set_of(decay, {10, 10, 100, -80}, seed));
            VYBEG_CLOSE(worst_deviation(found, truth_of(decay)), 0, 4.5);
        }
    }

    void two_angles_show_the_curve_of_a_resonator() {
        const FreeDecay decay = gyro();
        const DriftFunction found = drift_of(set_of(decay, {10, 32.5}, 5));
        QCOMPARE(found.order, 4);
        VYBEG_CLOSE(worst_deviation(found, truth_of(decay)), 0, 4.5);
    }

    // TRUTH row 1: near the circular state the regressors of the track are poles of its noise.
    void a_wave_that_passes_the_circular_state_has_the_resonators_curve_data() {
        QTest::addColumn<double>("split");
        QTest::addColumn<int>("runs");
        for (const double split : {0.0, 1e-4, 0.003, 0.03, 0.3, 1.0}) {
            for (const int runs : {1, 2, 4, 8}) {
                QTest::newRow(qPrintable(QString("%1 Hz, %2 runs").arg(split).arg(runs)))
                    << split << runs;
            }
        }
    }

    void a_wave_that_passes_the_circular_state_has_the_resonators_curve() {
        QFETCH(double, split);
        QFETCH(int, runs);
        double squares = 0;
        int count = 0;
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            FreeDecay decay = gyro();
            decay.split_hz = split;
            decay.theta_w = pi / 8;
            std::vector<double> starts;
            for (int k = 0; k < runs; ++k) {
                starts.push_back(22.5 * k + static_cast<double>(seed));
            }
            const std::vector<PhasorRun> set = set_of(decay, starts, 300 + 10 * seed);
            const Result<ResonatorFit> fit = fit_resonator(set, {}, {});
            QVERIFY(fit && fit->model == ResonatorModel::structured);
            const DriftFunction found = drift_function(set, *fit);
            const Eigen::Vector3d truth = truth_of(decay);
            for (Eigen::Index k = 0; k < found.coefficients.size(); ++k) {
                const double expected = k < 3 ? truth[k] : 0;
                squares += std::pow(found.coefficients[k] - expected, 2) / found.covariance(k, k);
                ++count;
            }
            // The same file's resonator has the same mean drift.
            if (found.order > 0) {
                const Estimate& rate = fit->resonator.angle_rate_rad_s;
                const double sd = std::sqrt(found.covariance(0, 0));
                VYBEG_CLOSE(found.coefficients[0], rate.value, 4 * sd);
            }
        }
        if (count > 0) {
            const double rms = std::sqrt(squares / count);
            VYBEG_AT_MOST(rms, 1.5, qPrintable(QString("rms pull %1 of %2").arg(rms).arg(count)));
        }
        if (runs != 1) {
            VYBEG_MORE(count, 0, "a set of two angles or more shows the curve");
        }
    }

    void a_circular_wave_has_no_drift() {
        FreeDecay decay = gyro();
        decay.a_B = 1;
        const DriftFunction found = drift_of(set_of(decay, four_starts, 6));
        QCOMPARE(found.order, 0);
    }

    void the_dynamics_have_the_same_curve() {
        const FreeDecay decay = gyro();
        SlowRates rates = SlowRates::Zero();
        rates[split_cos_at] = decay.split_hz * std::cos(4 * decay.theta_w);
        rates[split_sin_at] = decay.split_hz * std::sin(4 * decay.theta_w);
        rates[damping_cos_at] = decay.damping_anisotropy_per_s * std::cos(4 * decay.theta_tau);
        rates[damping_sin_at] = decay.damping_anisotropy_per_s * std::sin(4 * decay.theta_tau);
        rates[rotation_at] = 2 * decay.bryan * decay.omega_rad_s;
        rates[decay_at] = 1 / decay.tau_s;
        const Eigen::Matrix2cd m = SlowDynamics(rates).matrix();
        const Eigen::Vector3d truth = truth_of(decay);
        for (double theta = -0.8; theta < 0.8; theta += 0.1) {
            const double expected =
                truth[0] + truth[1] * std::cos(4 * theta) + truth[2] * std::sin(4 * theta);
            VYBEG_CLOSE(drift_of_dynamics(m, theta), expected, 1e-15);
        }
    }
};

VYBEG_TEST(TestDriftFunction, first, statistical, unsanitized)

}  // namespace test_drift_function

#include "test_drift_function.moc"
