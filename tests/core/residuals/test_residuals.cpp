// The residual of an analysis against the noise that was simulated.
#include "core/residuals/find_residuals.h"
#include "tests/closeness.h"
#include "tests/core/residuals/simulated_residuals.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <numbers>
#include <numeric>

namespace test_residuals {

using namespace vybeg;
using namespace vybeg::test;

class TestResiduals : public QObject {
    Q_OBJECT

private slots:
    // The variance of N samples has a relative sd of sqrt(2/N), their sd half of it. The taken up
    // share is that of the projection, to first order in noise / amplitude.
    void white_noise_leaves_a_residual_of_its_sd_data() {
        QTest::addColumn<double>("two_theta_A");
        QTest::addColumn<double>("a_B");
        QTest::addColumn<double>("f0_hz");
        QTest::addColumn<int>("window");
        QTest::addColumn<int>("hop");
        QTest::addColumn<unsigned>("seed");
        unsigned seed = 0;
        for (const int window : {20, 60, 1000, 33333}) {
            for (const double angle : {0.6, 1.2, 2.2, -0.5, -2.0, 3.0}) {
                const double a_B = seed % 2 == 0 ? 0.2 : -0.2;
                const double f0 = seed % 3 == 0 ? 5300 : seed % 3 == 1 ? 2017.3 : 11111.1;
                ++seed;
                QTest::addRow("%d samples, %g rad, seed %u", window, angle, seed)
                    << angle << a_B << f0 << window << window << seed;
            }
        }
        for (const auto& [window, hop] : {std::pair{60, 15}, {60, 7}, {60, 100}, {1000, 500}}) {
            QTest::addRow("%d samples each %d", window, hop)
                << 0.9 << -0.1 << 5300.0 << window << hop << ++seed;
        }
    }

    void white_noise_leaves_a_residual_of_its_sd() {
        QFETCH(double, two_theta_A);
        QFETCH(double, a_B);
        QFETCH(double, f0_hz);
        QFETCH(int, window);
        QFETCH(int, hop);
        QFETCH(unsigned, seed);
        FreeDecay decay = still_wave();
        decay.two_theta_A = two_theta_A;
        decay.a_B = a_B;
        decay.f0_hz = f0_hz;
        decay.seed = seed;
        const Recording recording = simulated_recording(decay);
        const Analysis analysis = analysed(recording, windows_of(window, hop));
        const Residuals found = residuals(recording, analysis);
        const auto count = static_cast<double>(found.used());
        VYBEG_MORE(count, 200000);
        // What windows take up is shared by both channels as the wave is: their mean is exact.
        const double power = 0.5 * (std::pow(found.c.noise_sd, 2) + std::pow(found.d.noise_sd, 2));
        VYBEG_CLOSE_RATIO(std::sqrt(power), noise, 5 * 0.5 / std::sqrt(count));
        for (const ResidualChannel* channel : {&found.c, &found.d}) {
            QCOMPARE(channel->moments.count, static_cast<std::size_t>(found.used()));
            VYBEG_CLOSE(channel->moments.mean, 0, 5 * noise / std::sqrt(count));
            VYBEG_CLOSE(channel->moments.skewness, 0, 5 * channel->moments.sd_skewness);
            VYBEG_CLOSE(channel->moments.kurtosis, 0, 5 * channel->moments.sd_kurtosis);
            const Histogram& histogram = channel->histogram;
            QCOMPARE(std::accumulate(histogram.counts.begin(), histogram.counts.end(),
                                     histogram.below + histogram.above),
                     found.used());
        }
        // One in a hundred of these spectra shows one.
        VYBEG_AT_MOST(found.lines.size(), 1, qPrintable(names_of(found)));
    }

    void white_noise_leaves_a_white_residual_data() {
        QTest::addColumn<int>("window");
        QTest::addColumn<unsigned>("seed");
        for (const int window : {1000, 33333}) {
            for (unsigned seed = 1; seed <= 4; ++seed) {
                QTest::addRow("%d samples, seed %u", window, seed) << window << seed;
            }
        }
    }

    // Windows this long take up no more than 0.25 % of the noise.
    void white_noise_leaves_a_white_residual() {
        QFETCH(int, window);
        QFETCH(unsigned, seed);
        FreeDecay decay = still_wave(30);
        decay.seed = seed;
        const Recording recording = simulated_recording(decay);
        const Residuals found = residuals(recording, analysed(recording, windows_of(window)));
        for (const ResidualChannel* channel : {&found.c, &found.d}) {
            const double whole = noise * noise / (decay.rate_hz / 2);
            // The segments' average scatters by 1.03/sqrt(segments); the largest of all bins lies
            // below 6 sd.
            const double scatter = 1.03 / std::sqrt(found.segments);
            double mean = 0;
            int bins = 0;
            for (std::size_t k = 2; k + 2 < channel->density.size(); ++k) {
                const double f = static_cast<double>(k) * found.bin_hz;
                if (std::abs(f - decay.f0_hz) > 3 * decay.rate_hz / window + 3 * found.bin_hz) {
                    VYBEG_CLOSE_RATIO(channel->density[k], whole, 6.5 * scatter);
                    mean += channel->density[k] / whole;
                    ++bins;
                }
            }
            VYBEG_CLOSE(mean / bins, 1, 5 * 1.5 * scatter / std::sqrt(bins));
            const std::vector<double>& r = channel->autocorrelation;
            QCOMPARE(r.front(), 1.0);
            int beyond = 0;
            for (std::size_t lag = 1; lag < r.size(); ++lag) {
                VYBEG_CLOSE(r[lag], 0, 5 / 1.96 * found.correlation_limit + 2.5 / window);
                beyond += std::abs(r[lag]) > found.correlation_limit ? 1 : 0;
            }
            if (window > 10000) {
                const auto lags = static_cast<double>(r.size() - 1);
                VYBEG_CLOSE(beyond, 0.05 * lags, 5 * std::sqrt(0.05 * lags));
            }
        }
    }

    // Short windows take the carrier out of the noise: the projection onto cos and sin leaves the
    // correlation -(2/n)(1 - k/n) cos(w k) in the mean over a window, the frequency adds a share.
    void short_windows_leave_the_correlation_of_their_projection() {
        FreeDecay decay = still_wave(30);
        const Recording recording = simulated_recording(decay);
        constexpr int window = 20;
        const Residuals found = residuals(recording, analysed(recording, windows_of(window)));
        const double w = 2 * std::numbers::pi * decay.f0_hz / decay.rate_hz;
        const double left = 1 - found.taken_up;
        double of_both = 0;
        for (std::size_t lag = 1; lag < 40; ++lag) {
            const double measured =
                0.5 * (found.c.autocorrelation[lag] + found.d.autocorrelation[lag]);
            const double inside = std::max(0.0, 1 - static_cast<double>(lag) / window);
            const double expected =
                -2.0 / window * inside * std::cos(w * static_cast<double>(lag)) / left;
            // The frequency is one of five parameters, for a fifth of all at most.
            VYBEG_CLOSE(measured, expected, 0.5 / window * inside + 4 * found.correlation_limit);
            of_both = std::max(of_both, std::abs(measured));
        }
        VYBEG_MORE(of_both, 0.05);
    }

    void its_spectral_density_adds_up_to_its_variance_data() {
        QTest::addColumn<int>("window");
        QTest::addColumn<double>("hum");
        for (const int window : {20, 60, 1000}) {
            QTest::addRow("%d samples", window) << window << 0.0;
            QTest::addRow("%d samples and hum", window) << window << 2e-3;
        }
    }

    void its_spectral_density_adds_up_to_its_variance() {
        QFETCH(int, window);
        QFETCH(double, hum);
        FreeDecay decay = still_wave(30);
        decay.hum = hum;
        const Recording recording = simulated_recording(decay);
        const Residuals found = residuals(recording, analysed(recording, windows_of(window)));
        for (const ResidualChannel* channel : {&found.c, &found.d}) {
            const double sum =
                std::accumulate(channel->density.begin(), channel->density.end(), 0.0);
            // Half of the first and the last segment has no second weight.
            VYBEG_CLOSE_RATIO(sum * found.bin_hz, std::pow(channel->moments.sd, 2), 3e-3);
        }
    }

    void calibration_and_first_electrode_are_those_of_the_analysis() {
        FreeDecay decay = still_wave(5);
        decay.kappa = 1.25;
        decay.offset_c = 0.2;
        decay.offset_d = -0.1;
        decay.delay_d_s = 3e-6;
        const Recording recording = simulated_recording(decay);
        Settings settings = windows_of(600);
        settings.calibration.kappa = 1.25;
        settings.calibration.offset_auto = true;
        settings.calibration.delay_d_s = 3e-6;
        settings.calibration.angle_zero_deg = 17;
        const Residuals found = residuals(recording, analysed(recording, settings));
        VYBEG_CLOSE_RATIO(found.c.noise_sd, noise, 0.01);
        // Noise of D is scaled with its samples; the delay's interpolation takes some of its band.
        VYBEG_CLOSE_RATIO(found.d.noise_sd, 1.25 * noise, 0.05);
        VYBEG_CLOSE(found.c.moments.mean, 0, 1e-4);
    }

    void each_algorithm_has_its_residual() {
        FreeDecay decay = still_wave(5);
        const Recording recording = simulated_recording(decay);
        for (const Algorithm algorithm :
             {Algorithm::phase_shift, Algorithm::moving_axes, Algorithm::demodulation,
              Algorithm::conjugate_gradient, Algorithm::maximum_likelihood}) {
            // Closed forms are exact at whole half-periods only.
            Settings settings = windows_of(1001);
            settings.snap = true;
            settings.algorithm = algorithm;
            const Residuals found = residuals(recording, analysed(recording, settings));
            VYBEG_CLOSE_RATIO(found.c.noise_sd, noise, 0.03);
        }
        // Without the quadrature wave its amplitude of 0.1 is left.
        Settings settings = windows_of(1001);
        settings.algorithm = Algorithm::in_phase;
        const Residuals found = residuals(recording, analysed(recording, settings));
        const double left =
            found.c.moments.sd * found.c.moments.sd + found.d.moments.sd * found.d.moments.sd;
        VYBEG_CLOSE_RATIO(left, 0.1 * 0.1 / 2, 0.03);
        const ResidualLine* line = line_near(found, decay.f0_hz);
        QVERIFY(line && line->origin == LineOrigin::wave);
    }

    void samples_belong_to_the_nearest_window() {
        const FreeDecay decay = still_wave(0.2);
        const SimulatedDecay samples = simulated(decay);
        const Recording recording = recording_of(samples.c, samples.d, decay.rate_hz);
        for (const auto& [length, hop] :
             {std::pair{60, 60}, {60, 13}, {61, 20}, {60, 1}, {60, 97}, {60, 98}}) {
            const Analysis analysis = analysed(recording, windows_of(length, hop));
            const auto found = residual_samples(recording, analysis, {}, {});
            QVERIFY(found);
            std::size_t at = 0;
            std::int64_t without = 0;
            const WindowPlan& plan = analysis.plan;
            const std::int64_t end = plan.start(plan.count - 1) + plan.length;
            for (std::int64_t j = plan.first; j < end; ++j) {
                std::int64_t nearest = 0;
                for (std::int64_t k = 1; k < plan.count; ++k) {
                    const auto off = [&](std::int64_t window) {
                        return std::abs(2 * (j - plan.start(window)) - plan.length + 1);
                    };
                    nearest = off(k) <= off(nearest) ? k : nearest;
                }
                if (j < plan.start(nearest) || j >= plan.start(nearest) + plan.length) {
                    ++without;
                    continue;
                }
                const auto row = static_cast<std::size_t>(nearest);
                const auto value = [&](SlowVariable variable) {
                    return analysis.track.values(variable)[row];
                };
                const double tau = 2 * std::numbers::pi * value(SlowVariable::f) *
                                       (static_cast<double>(j) / decay.rate_hz -
                                        plan.centre_s(nearest, decay.rate_hz)) -
                                   value(SlowVariable::alpha);
                const double angle = value(SlowVariable::two_theta_A);
                const double c = value(SlowVariable::a_A) * std::cos(tau) * std::cos(angle) -
                                 value(SlowVariable::a_B) * std::sin(tau) * std::sin(angle);
                VYBEG_LESS(at, found->c.size());
                VYBEG_CLOSE(found->c[at], samples.c[static_cast<std::size_t>(j)] - c, 1e-12);
                ++at;
            }
            QCOMPARE(found->c.size(), at);
            QCOMPARE(found->without, without);
            QCOMPARE(found->parts() > 1, hop > length);
        }
    }

    void one_window_is_all_of_its_samples() {
        const Recording recording = simulated_recording(still_wave(1));
        const Analysis analysis = analysed(recording, windows_of(600, 100));
        const Residuals found = residuals(recording, analysis, {{}, 7});
        QCOMPARE(found.used(), std::int64_t(600));
        const double rms = analysis.track.values(SlowVariable::rms)[7];
        const double mean_square =
            std::pow(found.c.moments.sd, 2) + std::pow(found.c.moments.mean, 2) +
            std::pow(found.d.moments.sd, 2) + std::pow(found.d.moments.mean, 2);
        VYBEG_CLOSE_RATIO(std::sqrt(mean_square), rms, 1e-9);
    }

    void a_range_is_that_of_its_samples() {
        const Recording recording = simulated_recording(still_wave(2));
        const Analysis analysis = analysed(recording, windows_of(60));
        const double rate = recording.rate_hz;
        QCOMPARE(residuals(recording, analysis, {{1000 / rate, 2999 / rate}, {}}).used(),
                 std::int64_t(2000));
        const Residuals none = residuals(recording, analysis, {{5, 6}, {}});
        VYBEG_AT_MOST(none.used(), 1);
        QVERIFY(none.c.density.empty() && none.lines.empty());
    }

    void missing_samples_and_their_windows_are_left_out() {
        FreeDecay decay = still_wave(3);
        SimulatedDecay samples = simulated(decay);
        for (std::size_t j = 20000; j < 20500; ++j) {
            samples.d[j] = std::nan("");
        }
        const Recording recording = recording_of(samples.c, samples.d, decay.rate_hz);
        const Analysis analysis = analysed(recording, windows_of(1000));
        const Residuals found = residuals(recording, analysis);
        QCOMPARE(found.without, std::int64_t(1000));
        QCOMPARE(found.used(), std::int64_t(98000));
        VYBEG_CLOSE_RATIO(found.d.noise_sd, noise, 0.015);
        VYBEG_MORE(found.segments, 0);
    }

    void a_long_range_is_sampled_in_blocks() {
        const Recording recording = simulated_recording(still_wave(60));
        const Analysis analysis = analysed(recording, windows_of(600));
        const Residuals found = residuals(recording, analysis);
        VYBEG_MORE(found.frames, (1 << 20));
        QCOMPARE(found.examined, std::int64_t(1 << 20));
        QCOMPARE(found.without, std::int64_t(0));
        VYBEG_CLOSE_RATIO(found.c.noise_sd, noise, 0.004);
    }

    void it_stops_when_asked() {
        const Recording recording = simulated_recording(still_wave(2));
        const Analysis analysis = analysed(recording, windows_of(60));
        std::stop_source stop;
        stop.request_stop();
        const auto found = find_residuals(recording, analysis, {}, JobControl(stop.get_token()));
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::interrupted);
    }
};

VYBEG_TEST(TestResiduals, threads)

}  // namespace test_residuals

#include "test_residuals.moc"
