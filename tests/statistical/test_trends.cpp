#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/track/trend.h"
#include "tests/closeness.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <random>

namespace test_trends {

using namespace vybeg;
using namespace vybeg::test;

// Decay time, drift, drift of the frequency and beat between two cursors, against the simulator,
// over 200 seeds each: the root mean square pull is known to 5 %, their mean to 7 %.
class TestTrends : public QObject {
    Q_OBJECT

private slots:
    void pulls_are_those_of_the_deviations_data() {
        QTest::addColumn<int>("algorithm");
        QTest::addColumn<int>("window");
        QTest::addColumn<int>("hop");
        const auto row = [](const char* name, Algorithm algorithm, int window, int hop) {
            QTest::newRow(name) << static_cast<int>(algorithm) << window << hop;
        };
        row("maximum likelihood", Algorithm::maximum_likelihood, 60, 60);
        row("overlapping", Algorithm::maximum_likelihood, 60, 13);
        row("short", Algorithm::maximum_likelihood, 6, 6);
        row("long", Algorithm::maximum_likelihood, 1000, 1000);
        row("conjugate gradient", Algorithm::conjugate_gradient, 60, 60);
    }

    void pulls_are_those_of_the_deviations() {
        QFETCH(int, algorithm);
        QFETCH(int, window);
        QFETCH(int, hop);
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> any(-1, 1);
        enum { decay, turn, frequency, count };
        std::array<double, count> squares{};
        std::array<double, count> sums{};
        for (int seed = 1; seed <= seeds; ++seed) {
            FreeDecay wave;
            wave.seconds = 1;
            wave.seed = static_cast<std::uint64_t>(seed);
            wave.f0_hz = 5300 + 37.3 * any(random);
            wave.a_B = 0.1 * any(random);
            wave.two_theta_A = 3 * any(random);
            wave.alpha = 3 * any(random);
            wave.tau_s = 200;
            wave.omega_rad_s = 0.05 * any(random);
            wave.frequency_drift_hz_s = 0.02 * any(random);
            wave.noise = 1e-3;
            Settings settings;
            settings.algorithm = static_cast<Algorithm>(algorithm);
            settings.window = window;
            settings.hop = hop;
            const auto analysis = analyse(simulated_recording(wave), settings, {});
            QVERIFY(analysis);
            const std::size_t apart = windows_apart(analysis->plan.length, analysis->plan.hop);
            const auto trend = [&](SlowVariable variable, TrendOf of) {
                return line_trend(analysis->track, variable, 0.2, 0.8, apart, of);
            };
            const auto of_a_A = trend(SlowVariable::a_A, TrendOf::logarithm);
            const auto of_angle = trend(SlowVariable::two_theta_A, TrendOf::value);
            const auto of_f = trend(SlowVariable::f, TrendOf::value);
            QVERIFY(of_a_A && of_angle && of_f);
            const auto tau = decay_time(*of_a_A);
            QVERIFY(tau);
            const std::array<double, count> pulls{
                (tau->tau_s - wave.tau_s) / tau->sd_s,
                (of_angle->slope_per_s + 2 * wave.bryan * wave.omega_rad_s) /
                    of_angle->sd_slope_per_s,
                (of_f->slope_per_s - wave.frequency_drift_hz_s) / of_f->sd_slope_per_s};
            for (std::size_t k = 0; k < count; ++k) {
                sums[k] += pulls[k];
                squares[k] += pulls[k] * pulls[k];
            }
        }
        for (std::size_t k = 0; k < count; ++k) {
            check(k, sums[k], squares[k]);
        }
    }

    // A frequency split turns the wave to and fro and lets a_B beat with it. The angle to the axis
    // is small, so that the third harmonic lies below the noise.
    void beats_are_those_of_the_split_data() {
        QTest::addColumn<int>("window");
        QTest::addColumn<int>("hop");
        QTest::newRow("windows") << 60 << 60;
        QTest::newRow("overlapping") << 60 << 17;
        QTest::newRow("longer") << 120 << 120;
    }

    void beats_are_those_of_the_split() {
        QFETCH(int, window);
        QFETCH(int, hop);
        std::mt19937_64 random(11);
        std::uniform_real_distribution<double> any(-1, 1);
        enum { of_a_B, of_angle, damping, count };
        std::array<double, count> squares{};
        int refused = 0;
        std::array<double, count> sums{};
        for (int seed = 1; seed <= seeds; ++seed) {
            FreeDecay wave;
            wave.seconds = 2;
            wave.seed = static_cast<std::uint64_t>(seed);
            wave.f0_hz = 5300 + 37.3 * any(random);
            wave.alpha = 3 * any(random);
            wave.split_hz = 2.5 + any(random);
            wave.theta_w = 1.5 * any(random);
            wave.two_theta_A = 2 * wave.theta_w + 0.02;
            wave.tau_s = 20;
            wave.noise = 1e-3;
            Settings settings;
            settings.window = window;
            settings.hop = hop;
            const auto analysis = analyse(simulated_recording(wave), settings, {});
            QVERIFY(analysis);
            const std::size_t apart = windows_apart(analysis->plan.length, analysis->plan.hop);
            const auto a_B = find_beat(analysis->track, SlowVariable::a_B, 0.2, 1.8, apart);
            const auto angle =
                find_beat(analysis->track, SlowVariable::two_theta_A, 0.2, 1.8, apart);
            if (!a_B || !angle) {
                ++refused;
                continue;
            }
            const std::array<double, count> pulls{
                (a_B->frequency_hz - wave.split_hz) / a_B->sd_frequency_hz,
                (angle->frequency_hz - wave.split_hz) / angle->sd_frequency_hz,
                (a_B->damping_per_s - 1 / wave.tau_s) / a_B->sd_damping_per_s};
            for (std::size_t k = 0; k < count; ++k) {
                sums[k] += pulls[k];
                squares[k] += pulls[k] * pulls[k];
            }
        }
        // Three standard deviations of chi^2 refuse about one beat in a hundred by chance.
        VYBEG_AT_MOST(refused, 12);
        for (std::size_t k = 0; k < count; ++k) {
            check(k, sums[k], squares[k]);
        }
    }

private:
    static constexpr int seeds = 200;

    static void check(std::size_t k, double sum, double square) {
        const double rms = std::sqrt(square / seeds);
        const QByteArray text = QByteArray::number(qulonglong(k)) + ": rms pull " +
                                QByteArray::number(rms) + ", mean " +
                                QByteArray::number(sum / seeds);
        VYBEG_MORE(rms, 0.9, text);
        VYBEG_LESS(rms, 1.1, text);
        VYBEG_CLOSE(sum / seeds, 0, 0.25, text);
    }
};

VYBEG_TEST(TestTrends)

}  // namespace test_trends

#include "test_trends.moc"
