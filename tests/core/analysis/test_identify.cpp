#include "core/analysis/identify.h"
#include "core/resonator/results/resonator_parameters.h"
#include "tests/closeness.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace test_identify {

using namespace vybeg;
using namespace vybeg::test;

namespace {

std::vector<Recording> runs_at(std::initializer_list<double> two_theta_A) {
    std::vector<Recording> runs;
    for (const double angle : two_theta_A) {
        const FreeDecay decay{.seconds = 4,
                              .two_theta_A = angle,
                              .split_hz = 0.1,
                              .tau_s = 40,
                              .noise = 1e-3,
                              .seed = static_cast<std::uint64_t>(10 * angle)};
        runs.push_back(simulated_recording(decay));
    }
    return runs;
}

// Channels without any error: no tolerance is assumed.
IdentifySettings exact_channels() {
    IdentifySettings settings;
    settings.tolerance.fill(0);
    return settings;
}

std::vector<Recording> two_runs() {
    return runs_at({0.3, 1.4});
}

}  // namespace

class TestIdentify : public QObject {
    Q_OBJECT

private slots:
    // What a file's digits leave open of the sample rate is open of every frequency, rate and time.
    void a_clock_of_few_digits_widens_what_it_counts() {
        std::vector<Recording> runs = two_runs();
        const Result<Identification> exact = identify(runs, exact_channels(), {});
        runs[1].rate_relative_sd = 1e-5;
        const Result<Identification> open = identify(runs, exact_channels(), {});
        QVERIFY(exact && open);
        const double wide = 1e-5 * 5300;

        VYBEG_LESS(exact->fit.resonator.f_mean_hz.uncertainty(), 1e-4);
        VYBEG_CLOSE_RATIO(open->fit.resonator.f_mean_hz.u, wide, 0.01);
        QCOMPARE(open->fit.modes.size(), std::size_t{2});
        for (const ModeEstimate& mode : open->fit.modes) {
            VYBEG_CLOSE_RATIO(mode.f_hz.u, wide, 0.01);
        }
        for (std::size_t k = 0; k < 2; ++k) {
            VYBEG_CLOSE_RATIO(open->fit.runs[k].f_offset_hz.u, wide, 0.01);
            VYBEG_CLOSE_RATIO(open->fit.runs[k].direction_f_hz.u, wide, 0.01);
        }
        QCOMPARE(open->runs[0].wave.f_hz.u, exact->runs[0].wave.f_hz.u);
        VYBEG_CLOSE_RATIO(open->runs[1].wave.f_hz.u, wide, 0.01);
        const Estimate& split = open->fit.resonator.split_hz;
        VYBEG_CLOSE_RATIO(
            split.uncertainty(),
            std::hypot(exact->fit.resonator.split_hz.uncertainty(), 1e-5 * split.value), 1e-6);
        QCOMPARE(open->fit.resonator.theta_w_rad.uncertainty(),
                 exact->fit.resonator.theta_w_rad.uncertainty());
        QCOMPARE(open->fit.resonator.f_mean_hz.sd, exact->fit.resonator.f_mean_hz.sd);
    }

    // A tolerance that is not told is assumed, unless zero is told; a told clock is one recorder's.
    void tolerances_are_assumed_where_none_is_told() {
        const std::vector<Recording> runs = runs_at({0, 0.8, 1.6, 2.4});
        IdentifySettings settings = exact_channels();
        const Result<Identification> exact = identify(runs, settings, {});
        const Result<Identification> silent = identify(runs, {}, {});
        settings.tolerance[rate_error] = 10;
        const Result<Identification> clocked = identify(runs, settings, {});
        QVERIFY(exact && silent && clocked);
        const ResonatorEstimate& none = exact->fit.resonator;
        const ResonatorEstimate& assumed = silent->fit.resonator;
        QVERIFY(std::isnan(none.split_hz.u));
        for (const auto member :
             {&ResonatorEstimate::split_hz, &ResonatorEstimate::theta_w_rad,
              &ResonatorEstimate::tau_s, &ResonatorEstimate::angle_rate_rad_s}) {
            VYBEG_MORE((assumed.*member).u, (assumed.*member).sd);
        }
        // Over 4 s a phase drift of 1e-4 rad is a frequency of 1e-4/(2 pi 4 s), and the split's
        // error between none and twice that.
        const std::size_t split = 1;
        VYBEG_CLOSE(silent->fit.shares[split][phase_drift_error], 4e-6, 4e-6);
        VYBEG_MORE(silent->fit.shares[split][phase_drift_error], 4e-7);
        for (const ModeEstimate& mode : silent->fit.modes) {
            VYBEG_MORE(mode.f_hz.u, mode.f_hz.sd);
        }
        for (const RunEstimate& run : silent->fit.runs) {
            VYBEG_MORE(run.direction_tau_s.u, run.direction_tau_s.sd);
            VYBEG_MORE(run.q_envelope.u, run.q_envelope.sd);
        }
        VYBEG_MORE(silent->drift.coefficient(0).u, silent->drift.coefficient(0).sd);
        QCOMPARE(silent->drift.coefficient(0).u > 0, true);
        QVERIFY(std::isnan(exact->drift.coefficient(0).u));

        VYBEG_CLOSE_RATIO(clocked->fit.resonator.f_mean_hz.u, 1e-5 * 5300, 0.01);
        VYBEG_CLOSE_RATIO(
            std::sqrt(std::pow(clocked->fit.resonator.tau_s.u, 2) - std::pow(none.tau_s.sd, 2)),
            1e-5 * 40, 0.05);
        VYBEG_CLOSE_RATIO(clocked->runs[0].wave.f_hz.u, 1e-5 * 5300, 0.01);
        QVERIFY(std::isnan(clocked->fit.runs[0].f_offset_hz.u));
        QVERIFY(std::isnan(clocked->fit.resonator.q.u));
    }

    // The budget of a recording with calibrated channels and a rate of few digits.
    void the_budget_of_calibrated_channels_holds_the_sample_rate() {
        std::vector<Recording> runs = runs_at({0, 0.8, 1.6, 2.4});
        runs[1].rate_relative_sd = 1e-5;
        IdentifySettings settings;
        settings.signal.calibration.kappa = 0.98;
        settings.tolerance[kappa_error] = 0.1;
        settings.tolerance[skew_error] = 0.01;
        const Result<Identification> found = identify(runs, settings, {});
        QVERIFY(found);
        const auto budget = uncertainty_budget(found->fit);
        VYBEG_AT_LEAST(budget.size(), 5);
        for (const ParameterBudget& row : budget) {
            double squares = row.statistical * row.statistical;
            for (const double share : row.shares) {
                squares += share * share;
            }
            VYBEG_CLOSE_RATIO(std::sqrt(squares), row.combined, 1e-6);
        }
        VYBEG_CLOSE_RATIO(budget.front().shares[rate_error], 1e-5 * 5300, 0.01);
    }

    // The raw parameters, of passports and the database, are those of the recorded channels, too.
    void a_gain_ratio_after_a_calibration_is_that_of_the_recorded_channels() {
        ResonatorFit fit;
        fit.resonator.kappa = {1.02, 0.01, {}};
        fit.raw = {{"f", "kappa"}, {5300, 1.02}, {4, 0.3, 0.3, 1e-4}};
        refer_to_recorded(0.5, fit);
        VYBEG_CLOSE_RATIO(fit.resonator.kappa.value, 0.51, 1e-15);
        VYBEG_CLOSE_RATIO(fit.resonator.kappa.sd, 0.005, 1e-15);
        QCOMPARE(fit.raw.values, (std::vector{5300.0, 0.51}));
        QCOMPARE(fit.raw.covariance, (std::vector{4.0, 0.15, 0.15, 2.5e-5}));
    }

    // Errors of the channels are those of the electrodes, wherever angles count from: the same
    // resonator, its axes moved by the angle of the first electrode.
    void the_angle_of_the_first_electrode_moves_the_angles_alone_data() {
        QTest::addColumn<double>("angle_zero_deg");
        for (const double angle : {-70.0, 10.0, 22.5, 30.0, 45.0}) {
            QTest::addRow("%g", angle) << angle;
        }
    }
    void the_angle_of_the_first_electrode_moves_the_angles_alone() {
        QFETCH(double, angle_zero_deg);
        std::vector<Recording> runs;
        for (int k = 0; k < 4; ++k) {
            const FreeDecay decay{.seconds = 8,
                                  .two_theta_A = 0.3 + k * std::numbers::pi / 4,
                                  .split_hz = 0.3,
                                  .theta_w = 0.4,
                                  .tau_s = 10,
                                  .damping_anisotropy_per_s = 0.01,
                                  .theta_tau = 0.2,
                                  .noise = 1e-3,
                                  .kappa = 1.03,
                                  .seed = static_cast<std::uint64_t>(k + 1),
                                  .skew_deg = 0.5};
            runs.push_back(simulated_recording(decay));
        }
        IdentifySettings settings;
        settings.tolerance[kappa_error] = 0.05;
        settings.tolerance[skew_error] = 1;
        const Result<Identification> plain = identify(runs, settings, {});
        settings.signal.calibration.angle_zero_deg = angle_zero_deg;
        const Result<Identification> turned = identify(runs, settings, {});
        QVERIFY(plain && turned);
        QCOMPARE(turned->fit.model, ResonatorModel::structured);
        for (const auto& parameter : resonator_parameters) {
            const Estimate& one = plain->fit.resonator.*parameter.member;
            const Estimate& other = turned->fit.resonator.*parameter.member;
            QCOMPARE(other.given(), one.given());
            if (!one.given()) {
                continue;
            }
            const bool angle = parameter.member == &ResonatorEstimate::theta_w_rad ||
                               parameter.member == &ResonatorEstimate::theta_tau_rad;
            const double moved = angle ? angle_zero_deg * std::numbers::pi / 180 : 0;
            const double difference =
                std::remainder(other.value - one.value + moved, angle ? std::numbers::pi / 2 : 1e9);
            VYBEG_LESS(std::abs(difference), 0.05 * one.sd, parameter.name);
            VYBEG_CLOSE_RATIO(other.sd, one.sd, 0.02, parameter.name);
            VYBEG_CLOSE_RATIO(other.uncertainty(), one.uncertainty(), 0.02, parameter.name);
        }
        // The skew, which the recordings do not show, moves it by more than the noise.
        const Estimate& kappa = turned->fit.resonator.kappa;
        VYBEG_CLOSE(kappa.value, 1.03, 3 * kappa.uncertainty());
        VYBEG_LESS(kappa.uncertainty(), 1e-3);
    }

    // A gain ratio known to a per cent moves the decay of a wave that turns.
    void the_waves_own_numbers_hold_the_tolerances() {
        const std::vector<Recording> runs = two_runs();
        IdentifySettings settings = exact_channels();
        const Result<Identification> exact = identify(runs, settings, {});
        settings.tolerance[kappa_error].reset();
        const Result<Identification> usual = identify(runs, settings, {});
        QVERIFY(usual && exact);
        for (std::size_t k = 0; k < runs.size(); ++k) {
            const WaveMotion& wide = usual->runs[k].wave;
            const WaveMotion& narrow = exact->runs[k].wave;
            QCOMPARE(narrow.decay_per_s.u, narrow.decay_per_s.sd);
            QCOMPARE(wide.decay_per_s.sd, narrow.decay_per_s.sd);
            VYBEG_MORE(wide.decay_per_s.u, wide.decay_per_s.sd);
        }
    }
};

VYBEG_TEST(TestIdentify, threads)

}  // namespace test_identify

#include "test_identify.moc"
