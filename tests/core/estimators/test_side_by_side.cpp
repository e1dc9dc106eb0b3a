// Closed forms and conjugate gradient of eight windows at once, against the same of one window by
// itself.
#include "core/estimators/batch/descent.h"
#include "core/estimators/batch/window_estimate.h"
#include "core/estimators/wave/estimator.h"
#include "tests/closeness.h"
#include "tests/core/estimators/still_windows.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>

namespace test_side_by_side {

using namespace vybeg;
using namespace vybeg::test;

class TestSideBySide : public QObject {
    Q_OBJECT

private slots:
    // The conjugate gradient of eight windows at once against that of one, which sums up the
    // samples in each step.
    void the_descent_ends_where_that_of_a_single_window_does_data() {
        QTest::addColumn<int>("n");
        QTest::addColumn<double>("noise");
        QTest::addColumn<bool>("typed");
        for (const int n : {5, 6, 22, 60, 601}) {
            for (const double noise : {0.1, 1e-2, 1e-3, 1e-5}) {
                for (const bool typed : {false, true}) {
                    QTest::addRow("n %d, noise %g%s", n, noise, typed ? ", typed start" : "")
                        << n << noise << typed;
                }
            }
        }
    }
    void the_descent_ends_where_that_of_a_single_window_does() {
        QFETCH(int, n);
        QFETCH(double, noise);
        QFETCH(bool, typed);
        constexpr std::size_t count = 43;
        const double f0 = 5300;
        const Samples samples = waves(n, count, f0, 0.03, noise, 23 + static_cast<unsigned>(n));
        EstimatorOptions options{.length = n, .rate_hz = rate, .f0_hz = f0};
        if (typed) {
            options.initial = StartValues{{0.9, 0.2, 0.3, -1.1}, f0 + 0.01 * rate / n};
        }
        const auto found =
            estimates(Algorithm::conjugate_gradient, options, block_of(samples, n), count);
        int compared = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const Window window = window_of(block_of(samples, n), k);
            const FrequencyBracket bracket = main_lobe(f0, rate, n);
            Five<double> start = in_phase_start(window, bracket.centre);
            if (typed) {
                start = five_of(options.initial->state, 2 * pi * options.initial->f_hz / rate);
                start[3] = std::remainder(start[3] - start[4] * static_cast<double>(k) * n, 2 * pi);
            }
            const Descent descent = descend(window, bracket, start);
            QCOMPARE(has(found[k].flags, Flag::not_converged), !descent.converged);
            const auto& [a_A, a_B, two_theta_A, alpha, w] = descent.at;
            const WaveState one = to_wave_state(to_phasors({a_A, a_B, two_theta_A, alpha}));
            const double thin = 1 / std::max(1e-3, one.a_A - std::abs(one.a_B));
            // Five noisy samples may have more than one minimum, and which of them a long first
            // step leads to hangs on its last digit: both have F no larger than the other's there.
            if (std::abs(found[k].state.a_A - one.a_A) > 1e-3) {
                continue;
            }
            ++compared;
            const double flat = 1 + 10 * found[k].sd.f_hz * n / rate;
            VYBEG_CLOSE(found[k].state.a_A, one.a_A, 1e-12 * flat);
            VYBEG_CLOSE(found[k].state.a_B, one.a_B, 1e-12 * flat);
            VYBEG_CLOSE(found[k].f_hz * 2 * pi / rate, w, 1e-11 * flat / n);
            if (!has(found[k].flags, Flag::circular)) {
                VYBEG_CLOSE(std::remainder(found[k].state.two_theta_A - one.two_theta_A, pi), 0,
                            1e-12 * flat * thin);
            }
        }
        VYBEG_AT_LEAST(compared, 41);
    }

    // J by its series and Newton's steps, against J by the samples and a search over the lobe,
    // which a carrier that lies too far from the windows' own frequency asks for. Relative to
    // amplitude 1; the search tells the frequency to 1e-9 of a lobe, where J is flat.
    void closed_forms_find_the_minimum_that_a_search_finds_data() {
        QTest::addColumn<Algorithm>("algorithm");
        QTest::addColumn<int>("n");
        QTest::addColumn<double>("noise");
        for (const Algorithm algorithm : {Algorithm::in_phase, Algorithm::phase_shift,
                                          Algorithm::moving_axes, Algorithm::demodulation}) {
            for (const int n : {6, 22, 60, 63, 601}) {
                for (const double noise : {0.03, 1e-3}) {
                    if (algorithm == Algorithm::phase_shift && n < 60) {
                        continue;  // another carrier's delay has another leakage
                    }
                    QTest::addRow("%s, n %d, noise %g", algorithm_name(algorithm).data(), n, noise)
                        << algorithm << n << noise;
                }
            }
        }
    }
    void closed_forms_find_the_minimum_that_a_search_finds() {
        QFETCH(Algorithm, algorithm);
        QFETCH(int, n);
        QFETCH(double, noise);
        constexpr std::size_t count = 40;
        const double f0 = 5300;
        const Samples samples = waves(n * 3, count, f0, 0.03, noise, 17 + static_cast<unsigned>(n));
        // Each window in the middle of its own wave, which goes on around it for the delay.
        const auto at = [&](double carrier) {
            return estimates(algorithm, {.length = n, .rate_hz = rate, .f0_hz = carrier},
                             {samples.c, samples.d, n, n, 3 * n}, count);
        };
        const std::vector<WaveEstimate> by_series = at(f0);
        const std::vector<WaveEstimate> by_search = at(f0 + 0.3 * rate / (pi * n));
        // The delay of algorithm 2 is made for the carrier: another one delays other noise.
        const bool delays = algorithm == Algorithm::phase_shift;
        const double tolerance = delays ? 1e-5 + noise : 1e-7;
        for (std::size_t k = 0; k < count; ++k) {
            const WaveEstimate& one = by_series[k];
            const WaveEstimate& other = by_search[k];
            if (delays && (k == 0 || k + 1 == count || one.flags != other.flags)) {
                continue;  // no room for the delay, or a circle in one noise and not in the other
            }
            QCOMPARE(one.flags, other.flags);
            // Where one of them is no number, the other is none.
            const auto same = [](double a, double b, double within) {
                if (!std::isnan(a) || !std::isnan(b)) {
                    VYBEG_CLOSE(a, b, within);
                }
            };
            const double thin = 1 / std::max(1e-2, one.state.a_A - std::abs(one.state.a_B));
            same(one.f_hz * n / rate, other.f_hz * n / rate, tolerance);
            same(one.state.a_A, other.state.a_A, tolerance);
            same(one.state.a_B, other.state.a_B, tolerance);
            if (!std::isnan(one.state.two_theta_A)) {
                VYBEG_CLOSE(std::remainder(one.state.two_theta_A - other.state.two_theta_A, pi), 0,
                            tolerance * thin);
            }
            same(one.rms, other.rms, tolerance);
            // The deviations hold the values' own distance from the best wave.
            same(one.sd.a_A, other.sd.a_A, tolerance * (1 + 100 * other.sd.a_A));
            same(one.sd.f_hz * n / rate, other.sd.f_hz * n / rate,
                 tolerance * (1 + 100 * other.sd.f_hz * n / rate));
        }
    }
};

VYBEG_TEST(TestSideBySide)

}  // namespace test_side_by_side

#include "test_side_by_side.moc"
