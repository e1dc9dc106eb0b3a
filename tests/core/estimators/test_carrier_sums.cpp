// The sums of windows whose frequency is not the carrier's, which drifts or was told wrong, against
// sums over their samples; and the estimates of every algorithm that uses them against those by the
// same sums at each window's own carrier.
#include "core/estimators/batch/carrier_sums.h"
#include "core/estimators/batch/profile.h"
#include "core/estimators/batch/window_estimate.h"
#include "tests/closeness.h"
#include "tests/core/estimators/still_windows.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <numbers>
#include <random>

namespace test_carrier_sums {

using namespace vybeg;
using namespace vybeg::test;

namespace {

struct Case {
    std::int64_t n = 0;
    std::int64_t hop = 0;
    double drift_hz_s = 0;
    double off_lobes = 0;  // the carrier told, from the one in the middle, in half main lobes
};

constexpr double f0 = 5300;

// A wave with quadrature and a little noise whose frequency is f0 in the middle.
Samples drifting(std::int64_t frames, double drift_hz_s) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> gauss(0, 1e-4);
    Samples signal;
    for (std::int64_t j = 0; j < frames; ++j) {
        const double t = (static_cast<double>(j) - 0.5 * static_cast<double>(frames)) / rate;
        const double phase = 2 * pi * (f0 * t + 0.5 * drift_hz_s * t * t);
        signal.c.push_back(0.8 * std::cos(phase) - 0.1 * std::sin(phase) + gauss(random));
        signal.d.push_back(0.6 * std::cos(phase) + 0.15 * std::sin(phase) + gauss(random));
    }
    return signal;
}

}  // namespace

class TestCarrierSums : public QObject {
    Q_OBJECT

private slots:
    void sums_are_those_over_the_samples_data() {
        QTest::addColumn<qint64>("n");
        QTest::addColumn<qint64>("hop");
        QTest::addColumn<double>("drift");
        QTest::addColumn<double>("off");
        for (const qint64 n : {60, 128, 129, 600, 1024, 1025, 4000, 10000, 33333}) {
            for (const qint64 hop : {qint64{1}, n / 1111, n / 100, n / 10, n / 3, n / 2, n}) {
                for (const double drift : {0.0, 0.02, 0.2}) {
                    for (const double off : {0.0, 0.1, -0.25, 0.5, -0.5}) {
                        if (hop > 0) {
                            QTest::addRow("n %lld, hop %lld, drift %g Hz/s, off %g", n, hop, drift,
                                          off)
                                << n << hop << drift << off;
                        }
                    }
                }
            }
        }
    }
    void sums_are_those_over_the_samples() {
        QFETCH(qint64, n);
        QFETCH(qint64, hop);
        QFETCH(double, drift);
        QFETCH(double, off);
        const auto count = static_cast<std::size_t>(
            hop * 2 <= n ? std::min<qint64>(2 * (n / hop), 300000 / hop + 1) : 8);
        const std::int64_t frames = static_cast<std::int64_t>(count - 1) * hop + n + 3;
        const Samples signal = drifting(frames, drift);
        const double w0 = 2 * pi * (f0 / rate + off / static_cast<double>(n));
        CarrierSums sums(n, w0);
        const WindowBlock block{signal.c, signal.d, 3, n, hop};
        sums.take(block, count);
        ProjectionBatch batch;
        BatchMaximum maximum;
        std::size_t groups = 0;
        std::size_t looked_at = 0;
        const std::size_t every = std::max<std::size_t>(1, count / 40);
        for (std::size_t first = 0, taken = 0; first < count; first += taken, ++groups) {
            taken = sums.next(first, batch, maximum);
            VYBEG_MORE(taken, 0);
            VYBEG_AT_MOST(taken, lane_count);
            for (std::size_t lane = 0; lane < taken; ++lane) {
                VYBEG_MORE(maximum.arrived[lane], 0,
                           qPrintable(QString("window %1 of %2").arg(first + lane).arg(count)));
                if ((first + lane) % every != 0) {
                    continue;
                }
                ++looked_at;
                const double w = sums.frame().w0() + 2 * maximum.x[lane] / static_cast<double>(n);
                const Window window = window_of(block, first + lane);
                const Phasors direct = window_projections(window, w);
                const Phasors series = lane_projections(batch, lane, maximum.x[lane]);
                // Relative to n samples of amplitude 1: rounding, and what the series of a hop
                // leaves out where the carrier drifts through its block.
                const double tolerance =
                    1e-13 + 3e-16 * static_cast<double>(n) + (drift > 0.1 ? 1e-9 : 1e-12);
                const QString which = QString("window %1").arg(first + lane);
                VYBEG_CLOSE(series.c, direct.c, tolerance * static_cast<double>(n),
                            qPrintable(which));
                VYBEG_CLOSE(series.d, direct.d, tolerance * static_cast<double>(n),
                            qPrintable(which));
                const WindowMoments moments = window_moments(window, w);
                const Jet2<double> power = profile_power(jets_of(moments, window_kernel(n, w)));
                // A step of Newton's from there moves by less than 1e-9 of a lobe.
                VYBEG_CLOSE(power.slope / power.bend * static_cast<double>(n), 0, 1e-7);
                const SampleProducts products = sample_products(window);
                VYBEG_CLOSE(batch.cc[lane], products.cc, 1e-12 * products.cc);
                VYBEG_CLOSE(batch.cd[lane], products.cd, 1e-12 * products.cc);
            }
        }
        VYBEG_AT_LEAST(looked_at, std::min<std::size_t>(count, 30));
    }

    // Two waves three hertz apart in windows of a second: the told one is estimated, not the
    // stronger one.
    void of_two_waves_the_told_one_is_meant() {
        constexpr std::int64_t n = 33333;
        constexpr std::int64_t hop = 500;
        constexpr std::size_t count = 40;
        Samples signal = drifting(n + hop * static_cast<std::int64_t>(count), 0);
        for (std::size_t j = 0; j < signal.c.size(); ++j) {
            const double phase = 2 * pi * (f0 + 3.1) / rate * static_cast<double>(j);
            signal.c[j] += 2.5 * std::cos(phase);
            signal.d[j] += 2 * std::cos(phase);
        }
        for (const Algorithm algorithm : {Algorithm::maximum_likelihood, Algorithm::demodulation}) {
            for (const double told : {0.0, 0.3, 3.1}) {
                const EstimatorOptions options{.length = n, .rate_hz = rate, .f0_hz = f0 + told};
                const WindowBlock block{signal.c, signal.d, 0, n, hop};
                const auto found = estimates(algorithm, options, block, count);
                for (std::size_t k = 0; k < count; ++k) {
                    const ProfileMaximum direct =
                        maximise_profile(window_of(block, k), main_lobe(options.f0_hz, rate, n));
                    const double f = direct.w * rate / (2 * pi);
                    VYBEG_CLOSE(found[k].f_hz, f, 1e-3,
                                qPrintable(QString("told %1, window %2").arg(told).arg(k)));
                }
            }
        }
    }

    // Far outside of the main lobe of the carrier that is told, windows are estimated as in it.
    void estimates_follow_a_drift_out_of_the_lobe() {
        constexpr std::int64_t n = 33333;
        constexpr std::int64_t hop = 7000;
        constexpr double drift = 0.2;
        constexpr std::size_t count = 100;
        const std::int64_t frames = n + hop * static_cast<std::int64_t>(count);
        const Samples signal = drifting(frames, drift);
        const EstimatorOptions options{.length = n, .rate_hz = rate, .f0_hz = f0};
        for (const Algorithm algorithm :
             {Algorithm::in_phase, Algorithm::phase_shift, Algorithm::moving_axes,
              Algorithm::demodulation, Algorithm::conjugate_gradient,
              Algorithm::maximum_likelihood}) {
            const auto found =
                estimates(algorithm, options, {signal.c, signal.d, 100, n, hop}, count);
            for (std::size_t k = 0; k + 1 < count; ++k) {
                const double centre = 100 + static_cast<double>(k) * hop + 0.5 * (n - 1) -
                                      0.5 * static_cast<double>(frames);
                VYBEG_CLOSE(
                    found[k].f_hz, f0 + drift * centre / rate, 1e-3,
                    qPrintable(
                        QString("%1, window %2").arg(algorithm_name(algorithm).data()).arg(k)));
                QVERIFY(!has(found[k].flags, Flag::at_bound));
            }
        }
    }
};

VYBEG_TEST(TestCarrierSums)

}  // namespace test_carrier_sums

#include "test_carrier_sums.moc"
