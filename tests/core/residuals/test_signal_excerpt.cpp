// Samples with the fitted wave over them against the signal without noise that was simulated.
#include "core/residuals/find_residuals.h"
#include "core/residuals/signal_curves.h"
#include "tests/closeness.h"
#include "tests/core/residuals/simulated_residuals.h"
#include "tests/needed.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <numbers>

namespace test_signal_excerpt {

using namespace vybeg;
using namespace vybeg::test;

namespace {

// A noisy decay, and the same without noise.
struct KnownSignal {
    explicit KnownSignal(FreeDecay decay) : recording(simulated_recording(decay)) {
        decay.noise = 0;
        truth = simulated(decay);
    }

    Recording recording;
    SimulatedDecay truth;
};

SignalSource source_of(const Recording& recording, const Settings& settings) {
    const auto analysis = std::make_shared<const Analysis>(analysed(recording, settings));
    return needed(signal_source(recording, analysis, {}));
}

SignalExcerpt excerpt_of(const SignalSource& source, std::int64_t first, std::int64_t count) {
    return needed(signal_excerpt(source, first, count, {}));
}

}  // namespace

class TestSignalExcerpt : public QObject {
    Q_OBJECT

private slots:
    void the_wave_lies_at_the_truth_and_leaves_the_noise_data() {
        QTest::addColumn<Algorithm>("algorithm");
        QTest::addColumn<double>("f0_hz");
        QTest::addColumn<double>("two_theta_A");
        QTest::addColumn<double>("a_B");
        QTest::addColumn<unsigned>("seed");
        unsigned seed = 100;
        for (const Algorithm algorithm :
             {Algorithm::phase_shift, Algorithm::moving_axes, Algorithm::demodulation,
              Algorithm::conjugate_gradient, Algorithm::maximum_likelihood}) {
            for (const double f0 : {2017.3, 5300.0, 11111.1}) {
                for (const double angle : {0.3, 1.4, -1.2, 2.8}) {
                    for (const double a_B : {0.2, -0.2}) {
                        ++seed;
                        QTest::addRow("algorithm %d, %g Hz, %g rad, a_B %g",
                                      static_cast<int>(algorithm), f0, angle, a_B)
                            << algorithm << f0 << angle << a_B << seed;
                    }
                }
            }
        }
    }

    // The wave has two parameters of each channel and the common frequency: its variance at a
    // sample is sigma^2 times the diagonal of the projection, 2.5 sigma^2 / n on average over both.
    // A closed form scatters more, and a wave at twice the carrier leaks into it, because no number
    // of samples is a whole number of half-periods. 150 windows tell the deviation to 3 %.
    void the_wave_lies_at_the_truth_and_leaves_the_noise() {
        QFETCH(Algorithm, algorithm);
        QFETCH(double, f0_hz);
        QFETCH(double, two_theta_A);
        QFETCH(double, a_B);
        QFETCH(unsigned, seed);
        FreeDecay decay = still_wave(4);
        decay.f0_hz = f0_hz;
        decay.two_theta_A = two_theta_A;
        decay.a_B = a_B;
        decay.seed = seed;
        const KnownSignal known(decay);
        Settings settings = windows_of(601);
        settings.snap = true;  // closed forms are exact at whole half-periods only
        settings.algorithm = algorithm;
        const SignalSource source = source_of(known.recording, settings);
        const auto n = static_cast<double>(source.analysis->plan.length);
        const std::int64_t first = 1234;
        const SignalExcerpt excerpt = excerpt_of(source, first, 90000);
        QCOMPARE(excerpt.size(), std::size_t(90000));
        VYBEG_CLOSE(excerpt.time_s(7), 1241 / decay.rate_hz, 1e-12);
        std::vector<double> error;
        std::vector<double> residual;
        for (std::size_t k = 0; k < excerpt.size(); ++k) {
            const auto j = static_cast<std::size_t>(first) + k;
            error.push_back(excerpt.fit_c[k] - known.truth.c[j]);
            error.push_back(excerpt.fit_d[k] - known.truth.d[j]);
            residual.push_back(excerpt.residual_c(k));
            residual.push_back(excerpt.residual_d(k));
        }
        const bool iterative = algorithm == Algorithm::maximum_likelihood ||
                               algorithm == Algorithm::conjugate_gradient;
        const double bound = noise * std::sqrt(2.5 / n);
        const double ratio = rms_of(error) / bound;
        VYBEG_MORE(ratio, 0.8);
        VYBEG_LESS(ratio, (iterative ? 1.2 : 4.0));
        const double k_sigma = 5 / std::sqrt(2.0 * static_cast<double>(residual.size()));
        // What a closed form adds is uncorrelated with the noise.
        VYBEG_CLOSE_RATIO(rms_of(residual), noise, k_sigma + (iterative ? 5 : 20) / n);
    }

    void the_curve_passes_through_the_wave_at_the_samples_and_between_them() {
        FreeDecay decay = still_wave(1);
        decay.noise = 0;
        decay.tau_s = 1e6;
        const Recording recording = simulated_recording(decay);
        const SignalSource source = source_of(recording, windows_of(600));
        const SignalExcerpt excerpt = excerpt_of(source, 3000, 19);
        const SignalCurve curve = wave_curve(*source.analysis, decay.rate_hz, excerpt.time_s(0),
                                             excerpt.time_s(18), 18 * 40 + 1);
        for (std::size_t k = 0; k < excerpt.size(); ++k) {
            VYBEG_CLOSE(curve.c[40 * k], excerpt.fit_c[k], 1e-9);
            VYBEG_CLOSE(curve.d[40 * k], excerpt.fit_d[k], 1e-9);
            VYBEG_CLOSE(excerpt.fit_c[k], excerpt.c[k], 1e-6);
        }
        // Three periods of a sinusoid: it obeys x'' = -w^2 x.
        const double step = curve.time_s[1] - curve.time_s[0];
        const double turn = 2 * (1 - std::cos(2 * std::numbers::pi * decay.f0_hz * step));
        for (std::size_t k = 1; k + 1 < curve.c.size(); ++k) {
            VYBEG_CLOSE(curve.c[k + 1] - 2 * curve.c[k] + curve.c[k - 1], -turn * curve.c[k], 1e-7);
        }
    }

    void its_amplitudes_are_those_of_the_channels_data() {
        QTest::addColumn<double>("two_theta_A");
        QTest::addColumn<double>("a_B");
        for (const double angle : {0.0, 0.7, -1.3, 1.57, 2.9}) {
            QTest::addRow("%g rad", angle) << angle << 0.2;
            QTest::addRow("%g rad, a_B < 0", angle) << angle << -0.3;
        }
    }

    void its_amplitudes_are_those_of_the_channels() {
        QFETCH(double, two_theta_A);
        QFETCH(double, a_B);
        FreeDecay decay = still_wave(3);
        decay.two_theta_A = two_theta_A;
        decay.a_B = a_B;
        const KnownSignal known(decay);
        const SignalSource source = source_of(known.recording, windows_of(600));
        const SignalCurve curve = amplitude_curve(*source.analysis, decay.rate_hz, 0.5, 2.5, 50);
        VYBEG_LESS(curve.time_s.front(), 0.53);
        VYBEG_MORE(curve.time_s.back(), 2.47);
        for (std::size_t k = 0; k < curve.time_s.size(); ++k) {
            double c = 0;
            double d = 0;
            const auto middle = static_cast<std::int64_t>(curve.time_s[k] * decay.rate_hz);
            for (std::int64_t j = middle - 300; j < middle + 300; ++j) {
                c = std::max(c, std::abs(known.truth.c[static_cast<std::size_t>(j)]));
                d = std::max(d, std::abs(known.truth.d[static_cast<std::size_t>(j)]));
            }
            // The largest of 600 samples at 95 phases misses a crest by 1e-3 at most.
            VYBEG_CLOSE(curve.c[k], c, 2e-3);
            VYBEG_CLOSE(curve.d[k], d, 2e-3);
        }
    }

    void samples_without_a_window_have_no_wave() {
        FreeDecay decay = still_wave(0.3);
        const Recording recording = simulated_recording(decay);
        Settings settings = windows_of(60, 97);
        settings.from_s = 0.05;
        const SignalSource source = source_of(recording, settings);
        const WindowPlan& plan = source.analysis->plan;
        const SignalExcerpt all = excerpt_of(source, 0, recording.frames());
        const SignalCurve curve =
            wave_curve(*source.analysis, decay.rate_hz, 0, recording.seconds(),
                       static_cast<int>(recording.frames()) + 1);
        for (std::int64_t j = 0; j < recording.frames(); ++j) {
            bool inside = false;
            for (std::int64_t k = 0; k < plan.count; ++k) {
                inside = inside || (j >= plan.start(k) && j < plan.start(k) + plan.length);
            }
            const auto at = static_cast<std::size_t>(j);
            QCOMPARE(std::isfinite(all.fit_c[at]), inside);
            QCOMPARE(std::isfinite(all.fit_d[at]), inside);
            QCOMPARE(std::isfinite(curve.c[at]), inside);
            QVERIFY(std::isfinite(all.c[at]));
        }
    }

    void overlapping_windows_give_the_wave_of_the_nearest() {
        FreeDecay decay = still_wave(0.2);
        const Recording recording = simulated_recording(decay);
        const SignalSource source = source_of(recording, windows_of(60, 15));
        const auto samples = residual_samples(recording, *source.analysis, {}, {});
        const SignalExcerpt excerpt =
            excerpt_of(source, source.analysis->plan.first, std::ssize(samples->c));
        for (std::size_t k = 0; k < excerpt.size(); ++k) {
            QCOMPARE(excerpt.residual_c(k), samples->c[k]);
            QCOMPARE(excerpt.residual_d(k), samples->d[k]);
        }
    }

    void calibration_filter_and_gaps_are_those_of_the_analysis() {
        FreeDecay decay = still_wave(3);
        decay.offset_c = 0.2;
        decay.kappa = 1.25;
        const Recording recording = simulated_recording(decay);
        Settings settings = windows_of(600);
        settings.calibration.kappa = 1.25;
        settings.calibration.offset_auto = true;
        settings.filter = Band{4000, 6500};
        const SignalSource source = source_of(recording, settings);
        const SignalExcerpt excerpt = excerpt_of(source, 40000, 20000);
        const TimeRange range{excerpt.time_s(0), excerpt.time_s(excerpt.size() - 1)};
        const auto known = residual_samples(recording, *source.analysis, {range, {}}, {});
        QVERIFY(known);
        QCOMPARE(known->c.size(), excerpt.size());
        std::vector<double> residual;
        for (std::size_t k = 0; k < excerpt.size(); ++k) {
            VYBEG_CLOSE(excerpt.residual_c(k), known->c[k], 1e-12);
            VYBEG_CLOSE(excerpt.residual_d(k), known->d[k], 1e-12);
            residual.push_back(excerpt.residual_c(k));
        }
        // The band-pass lets through 2500 of 16667 Hz, and a part beside its edges.
        const double inside = noise * std::sqrt(2500 / 16666.5);
        VYBEG_MORE(rms_of(residual), 0.95 * inside);
        VYBEG_LESS(rms_of(residual), 1.5 * inside);
    }

    void without_an_analysis_samples_are_as_recorded_and_ends_are_cut() {
        const SimulatedDecay samples = simulated(still_wave(0.1));
        const Recording recording = recording_of(samples.c, samples.d, 33333);
        const auto source = signal_source(recording, nullptr, {});
        QVERIFY(source);
        const SignalExcerpt excerpt = excerpt_of(*source, -5, 100);
        QCOMPARE(excerpt.first, std::int64_t(0));
        QCOMPARE(excerpt.size(), std::size_t(95));
        QCOMPARE(excerpt.d[94], samples.d[94]);
        QVERIFY(std::isnan(excerpt.fit_c[3]));
        QCOMPARE(excerpt_of(*source, recording.frames() - 4, 100).size(), std::size_t(4));
        QCOMPARE(excerpt_of(*source, recording.frames() + 4, 100).size(), std::size_t(0));
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(signal_excerpt(*source, 0, 9, JobControl(stop.get_token())).error().code,
                 ErrorCode::interrupted);
    }
};

VYBEG_TEST(TestSignalExcerpt)

}  // namespace test_signal_excerpt

#include "test_signal_excerpt.moc"
