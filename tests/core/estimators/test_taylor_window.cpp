// Maximum likelihood by the series of eight windows at once, against the road of one window by
// itself, which touches its samples at every trial frequency.
#include "core/estimators/batch/profile.h"
#include "core/estimators/batch/projection_sums.h"
#include "core/estimators/batch/taylor_window.h"
#include "core/estimators/batch/window_estimate.h"
#include "core/estimators/wave/estimator.h"
#include "tests/closeness.h"
#include "tests/core/estimators/still_windows.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <limits>

namespace test_taylor_window {

using namespace vybeg;
using namespace vybeg::test;

class TestTaylorWindow : public QObject {
    Q_OBJECT

private slots:
    void projections_and_kernel_are_those_of_the_window() {
        for (const std::int64_t n : {5, 6, 22, 63, 600, 1024, 1025, 33333, 200000}) {
            for (const double f0 : {1234.5, 5300.0, 14000.0}) {
                const Samples samples = waves(n, 3, f0, 0.05, 0.1, 7);
                const TaylorBasis basis(n, 2 * pi * f0 / rate);
                ProjectionBatch batch;
                ProjectionSums sums(basis);
                sums.take(block_of(samples, n), 3);
                sums.batch(0, 3, batch);
                const auto size = static_cast<double>(n);
                for (const double x : {-0.06, -0.01, 0.0, 0.033, 0.06}) {
                    const double w = basis.w0() + 2 * x / size;
                    for (std::size_t lane = 0; lane < 3; ++lane) {
                        const Window window = window_of(block_of(samples, n), lane);
                        const Phasors direct = window_projections(window, w);
                        const Phasors series = lane_projections(batch, lane, x);
                        // Relative to n samples of amplitude 1; the phase of a long window has its
                        // own rounding, 1e-16 of w u.
                        const double tolerance = 1e-14 + 2e-16 * size;
                        VYBEG_CLOSE(series.c, direct.c, tolerance * size);
                        VYBEG_CLOSE(series.d, direct.d, tolerance * size);
                    }
                    const WindowKernel direct = window_kernel(n, w);
                    const WindowKernel series = basis.kernel(x);
                    // The closed form divides by sin w and its derivatives by its powers.
                    const double tolerance = 1e-12 + 1e-15 * size;
                    VYBEG_CLOSE(series.gram_cos, direct.gram_cos, tolerance * size);
                    VYBEG_CLOSE(series.gram_sin, direct.gram_sin, tolerance * size);
                    VYBEG_CLOSE(series.slope, direct.slope, tolerance * size * size);
                    VYBEG_CLOSE(series.bend, direct.bend, tolerance * size * size * size);
                    QCOMPARE(series.spread, direct.spread);
                }
            }
        }
    }

    void estimates_are_those_of_single_windows_data() {
        QTest::addColumn<int>("n");
        QTest::addColumn<double>("f0");
        QTest::addColumn<double>("off");  // of the frequency, in x
        QTest::addColumn<double>("noise");
        for (const int n : {5, 6, 7, 22, 60, 63, 600}) {
            for (const double f0 : {4000.0, 5300.0, 5301.7, 9000.0}) {
                for (const double noise : {0.1, 1e-2, 1e-3, 1e-5, 0.0}) {
                    for (const double off : {0.0, 0.04, 1.0}) {
                        if (f0 * n > 0.75 * rate) {  // three quarters of a period
                            QTest::addRow("n %d, %g Hz, noise %g, off %g", n, f0, noise, off)
                                << n << f0 << off << noise;
                        }
                    }
                }
            }
        }
    }
    void estimates_are_those_of_single_windows() {
        QFETCH(int, n);
        QFETCH(double, f0);
        QFETCH(double, off);
        QFETCH(double, noise);
        constexpr std::size_t count = 43;  // not a multiple of the lanes
        const Samples samples = waves(n, count, f0, off, noise, 11 + static_cast<unsigned>(n));
        const EstimatorOptions options{.length = n, .rate_hz = rate, .f0_hz = f0};
        const auto found =
            estimates(Algorithm::maximum_likelihood, options, block_of(samples, n), count);
        for (std::size_t k = 0; k < count; ++k) {
            const Window window = window_of(block_of(samples, n), k);
            const ProfileMaximum maximum = maximise_profile(window, main_lobe(f0, rate, n));
            const WaveEstimate one =
                complete_estimate(maximum.phasors, maximum.w, maximum.flags, window, options);
            QCOMPARE(found[k].flags, one.flags);
            // Short noisy windows with no clear maximum may climb another hill of the same lobe
            // from another step; those that have one agree.
            const auto same = [&](double a, double b, double tolerance, const char* what) {
                if (!std::isnan(a) || !std::isnan(b)) {
                    VYBEG_WITHIN(a, b, tolerance, qPrintable(QString("window %1, ").arg(k) + what));
                }
            };
            // The flatter the power's maximum, the less rounding tells where it is.
            const double flat = 1 + one.sd.f_hz * n / rate * 10;
            const double thin = 1 / std::max(1e-3, one.state.a_A - std::abs(one.state.a_B));
            same(found[k].state.a_A, one.state.a_A, 1e-12 * flat, "a_A");
            same(found[k].state.a_B, one.state.a_B, 1e-12 * flat, "a_B");
            const bool angles = !has(one.flags, Flag::circular);
            QCOMPARE(std::isnan(found[k].state.two_theta_A), !angles);
            if (angles) {
                same(std::remainder(found[k].state.two_theta_A - one.state.two_theta_A, pi), 0.0,
                     1e-12 * flat * thin, "2theta_A");
            }
            same(found[k].f_hz * n / rate, one.f_hz * n / rate, 1e-12 * flat, "f");
            same(std::remainder(found[k].delta_phi_CD - one.delta_phi_CD, 2 * pi), 0.0,
                 1e-11 * flat * thin, "dphi_CD");
            same(found[k].rms, one.rms, 1e-9 * one.rms + 1e-12, "rms");
            same(found[k].orthogonality, one.orthogonality, 1e-12 * flat * thin, "orthogonality");
            if (noise > 0) {
                // The steady noise is a difference: of the residual and the motion in it.
                const double cancelled =
                    std::max(1.0, one.noise * one.noise / (one.steady_noise * one.steady_noise));
                const double digits = 1e-8 * flat * cancelled;
                same(found[k].sd.a_A / one.sd.a_A, 1, digits, "sd a_A");
                same(found[k].sd.a_B / one.sd.a_B, 1, digits, "sd a_B");
                if (angles) {
                    const double tolerance = digits * thin;
                    same(found[k].sd.two_theta_A / one.sd.two_theta_A, 1, tolerance, "sd 2theta_A");
                    same(found[k].sd.alpha / one.sd.alpha, 1, tolerance, "sd alpha");
                }
                same(found[k].sd.f_hz / one.sd.f_hz, 1, digits, "sd f");
                same(found[k].sd.delta_phi_CD / one.sd.delta_phi_CD, 1, digits, "sd dphi");
            }
        }
    }

    void overlapping_windows_are_those_that_stand_apart_data() {
        QTest::addColumn<qint64>("n");
        QTest::addColumn<qint64>("hop");
        for (const auto& [n, hop] : {std::pair<qint64, qint64>{60, 1},
                                     {129, 1},
                                     {129, 64},
                                     {200, 3},
                                     {600, 6},
                                     {600, 7},
                                     {600, 300},
                                     {1024, 511},
                                     {1025, 512},
                                     {1500, 1},
                                     {5000, 700},
                                     {33333, 333},
                                     {33333, 16666}}) {
            QTest::addRow("n %lld, hop %lld", n, hop) << n << hop;
        }
    }
    void overlapping_windows_are_those_that_stand_apart() {
        QFETCH(qint64, n);
        QFETCH(qint64, hop);
        constexpr std::size_t count = 27;
        const double f0 = 5299.3;
        // One wave from the first sample to the last, near the carrier.
        const std::int64_t frames = n + (count - 1) * hop + 5;
        const Samples samples =
            waves(frames, 1, f0, 0.02 * static_cast<double>(frames) / static_cast<double>(n), 0.01,
                  static_cast<std::uint64_t>(n + hop));
        const TaylorBasis basis(n, 2 * pi * f0 / rate);
        const WindowBlock block{samples.c, samples.d, 5, n, hop};
        ProjectionSums sums(basis);
        sums.take(block, count);
        for (std::size_t k = 0; k < count; ++k) {
            ProjectionBatch batch;
            sums.batch(k, 1, batch);
            const Window window = window_of(block, k);
            const auto size = static_cast<double>(n);
            for (const double x : {-0.2, 0.0, 0.05}) {
                const Phasors direct = window_projections(window, basis.w0() + 2 * x / size);
                const Phasors series = lane_projections(batch, 0, x);
                // As above; at x = 0.2 what is cut off of the series is 6e-11.
                const double tolerance = 1e-14 + 2e-16 * size + (std::abs(x) > 0.1 ? 6e-11 : 0);
                VYBEG_CLOSE(series.c, direct.c, tolerance * size);
                VYBEG_CLOSE(series.d, direct.d, tolerance * size);
            }
            const SampleProducts products = sample_products(window);
            VYBEG_CLOSE_RATIO(batch.cc[0], products.cc, 1e-13);
            VYBEG_CLOSE_RATIO(batch.dd[0], products.dd, 1e-13);
            VYBEG_CLOSE(batch.cd[0], products.cd, 1e-13 * (products.cc + products.dd));
        }
        // The same windows of a block that begins later: the same bits.
        constexpr std::size_t later = 9;
        ProjectionSums others(basis);
        others.take(
            {block.c, block.d, block.first + static_cast<std::int64_t>(later) * hop, n, hop},
            count - later);
        ProjectionBatch one;
        ProjectionBatch other;
        sums.batch(later, lane_count, one);
        others.batch(0, lane_count, other);
        QVERIFY(one.c_cos == other.c_cos && one.c_sin == other.c_sin && one.cc == other.cc);
        QVERIFY(one.d_cos == other.d_cos && one.d_sin == other.d_sin && one.dd == other.dd);
    }

    void a_long_window_is_estimated_as_by_itself() {
        for (const std::int64_t n : {1025, 33333, 131073, 400000}) {
            const Samples samples = waves(n, 1, 5300, 0.01, 1e-3, 5);
            const auto found =
                estimates(Algorithm::maximum_likelihood,
                          {.length = n, .rate_hz = rate, .f0_hz = 5300}, block_of(samples, n), 1);
            const ProfileMaximum maximum =
                maximise_profile({samples.c, samples.d}, main_lobe(5300, rate, n));
            const WaveState one = to_wave_state(maximum.phasors);
            // As far as w itself, a number of 53 bits, fixes the phase at the ends of a window.
            const double tolerance = 1e-13 + 1e-16 * static_cast<double>(n);
            VYBEG_CLOSE(found[0].state.a_A, one.a_A, tolerance);
            VYBEG_CLOSE(found[0].state.a_B, one.a_B, tolerance);
            VYBEG_CLOSE(found[0].state.two_theta_A, one.two_theta_A, tolerance);
            VYBEG_CLOSE(found[0].f_hz, maximum.w * rate / (2 * pi),
                        10 * tolerance * rate / static_cast<double>(n));
        }
    }

    void a_missing_sample_spoils_no_overlapping_window_without_it() {
        constexpr std::int64_t n = 600;
        constexpr std::int64_t hop = 7;
        constexpr std::size_t count = 300;
        constexpr std::size_t bad = 1400;
        Samples samples = waves(n + hop * static_cast<std::int64_t>(count), 1, 5300, 0.01, 1e-3, 3);
        samples.d[bad] = std::numeric_limits<double>::quiet_NaN();
        const auto found =
            estimates(Algorithm::maximum_likelihood, {.length = n, .rate_hz = rate, .f0_hz = 5300},
                      {samples.c, samples.d, 0, n, hop}, count);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t start = k * hop;
            QCOMPARE(has(found[k].flags, Flag::gap), start <= bad && bad < start + n);
        }
    }

    void a_missing_sample_is_a_gap_of_its_window_alone() {
        for (const double bad :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            Samples samples = waves(60, 20, 5300, 0.01, 1e-3, 3);
            samples.d[60 * 9 + 59] = bad;
            const EstimatorOptions options{.length = 60, .rate_hz = rate, .f0_hz = 5300};
            for (const Algorithm algorithm :
                 {Algorithm::in_phase, Algorithm::moving_axes, Algorithm::demodulation,
                  Algorithm::maximum_likelihood}) {
                const auto found = estimates(algorithm, options, block_of(samples, 60), 20);
                for (std::size_t k = 0; k < found.size(); ++k) {
                    QCOMPARE(has(found[k].flags, Flag::gap), k == 9);
                    QCOMPARE(std::isnan(found[k].state.a_A), k == 9);
                }
            }
        }
    }
};

VYBEG_TEST(TestTaylorWindow)

}  // namespace test_taylor_window

#include "test_taylor_window.moc"
