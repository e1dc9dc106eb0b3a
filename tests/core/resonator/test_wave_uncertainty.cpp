// The wave's own numbers under channel errors drawn from their tolerances: the truth, that of the
// same noise without errors, lies within 2u (TRUTH principle 2).
#include "core/resonator/runs/wave_motion.h"
#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/test_registry.h"

#include <array>
#include <random>

namespace test_wave_uncertainty {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

namespace {

constexpr std::int64_t window = 3333;
constexpr std::array members{&WaveMotion::f_hz, &WaveMotion::theta_rate_rad_s,
                             &WaveMotion::quadrature_rate_per_s, &WaveMotion::decay_per_s};

// A wave that moves: errors of the channels move all its numbers.
FreeDecay moving_wave(double two_theta, double a_B) {
    FreeDecay decay = reference();
    decay.seconds = 14;
    decay.split_hz = 0.01;
    decay.theta_w = 0.2;
    decay.omega_rad_s = 0.1;
    decay.two_theta_A = two_theta;
    decay.a_B = a_B;
    decay.noise = 1e-4;
    return decay;
}

double normal(std::mt19937_64& random) {
    const double u = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
    const double v = static_cast<double>(random() >> 11) * 0x1p-53;
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * pi * v);
}

}  // namespace

class TestWaveUncertainty : public QObject {
    Q_OBJECT

private slots:
    // Which channel is called D decides nothing: a wave in C had no u of a drift.
    void drifts_of_either_channel_count() {
        const ChannelTolerance told =
            channels({{phase_drift_error, 1e-3}, {gain_drift_error, 1e-3}});
        for (const double two_theta : {0.0, 0.4, 1.3, 2.6}) {
            const PhasorRun run = simulated_phasors(moving_wave(two_theta, 0.1), window, 3);
            PhasorRun exchanged = run;
            std::swap(exchanged.c, exchanged.d);
            const WaveMotion one = wave_motion(run, told, {});
            const WaveMotion other = wave_motion(exchanged, told, {});
            for (const auto member : members) {
                VYBEG_CLOSE((other.*member).u, (one.*member).u, 0.05 * (one.*member).u);
            }
            VYBEG_MORE(one.decay_per_s.u, 0.5 * 1e-3 / 14);
        }
    }

    void the_truth_lies_within_u_data() {
        QTest::addColumn<int>("error");
        for (int error = 0; error < 7; ++error) {
            QTest::addRow("%d", error) << error;
        }
    }

    // One error at a time, then all of them.
    void the_truth_lies_within_u() {
        QFETCH(int, error);
        const ChannelTolerance all = channels({{kappa_error, 0.01},
                                               {skew_error, 2e-3},
                                               {delay_error, 2e-3},
                                               {crosstalk_error, 1e-3},
                                               {phase_drift_error, 1e-3},
                                               {gain_drift_error, 1e-3}});
        ChannelTolerance told = all;
        if (error < 6) {
            told = {};
            told[static_cast<std::size_t>(error)] = all[static_cast<std::size_t>(error)];
        }
        std::array<int, 4> within{};
        std::array<bool, 4> widened{};
        int count = 0;
        std::mt19937_64 random(static_cast<std::uint64_t>(error) + 1);
        for (const double two_theta : {-2.5, -0.6, 0.3, 1.2, 2.9}) {
            for (const double a_B : {-0.2, 0.05}) {
                const FreeDecay decay = moving_wave(two_theta, a_B);
                for (std::uint64_t seed = 1; seed <= 8; ++seed) {
                    PhasorRun run = simulated_phasors(decay, window, seed);
                    const WaveMotion truth = wave_motion(run);
                    const double gain = 1 / (1 + told[kappa_error] * normal(random));
                    const double phase = told[delay_error] * normal(random);
                    const std::complex cross(told[skew_error] * normal(random),
                                             told[crosstalk_error] * normal(random));
                    const double phase_drift = told[phase_drift_error] * normal(random);
                    const double gain_drift = told[gain_drift_error] * normal(random);
                    for (std::size_t k = 0; k < run.c.size(); ++k) {
                        const double x = run.time_s[k] / 14;
                        run.d[k] = run.d[k] * gain *
                                       std::polar(1 + gain_drift * x, phase + phase_drift * x) +
                                   cross * run.c[k];
                    }
                    const WaveMotion found = wave_motion(run, told);
                    ++count;
                    for (std::size_t k = 0; k < members.size(); ++k) {
                        const Estimate& number = found.*members[k];
                        QVERIFY(number.given());
                        VYBEG_AT_LEAST(number.u, number.sd);
                        const double off = std::abs(number.value - (truth.*members[k]).value);
                        within[k] += off < 2 * number.u ? 1 : 0;
                        widened[k] = widened[k] || number.u > 1.5 * number.sd;
                    }
                }
            }
        }
        for (std::size_t k = 0; k < members.size(); ++k) {
            const QString text = QString("number %1: %2 of %3").arg(k).arg(within[k]).arg(count);
            VYBEG_MORE(within[k], 0.9 * count, qPrintable(text));
        }
        QVERIFY(std::ranges::find(widened, true) != widened.end());
    }

    void no_tolerance_adds_nothing() {
        const PhasorRun run = simulated_phasors(moving_wave(0.3, 0.1), window, 1);
        const WaveMotion found = wave_motion(run, {});
        for (const auto member : members) {
            QCOMPARE((found.*member).u, (found.*member).sd);
        }
        QCOMPARE(found.tau_s.u, found.tau_s.sd);
    }
};

VYBEG_TEST(TestWaveUncertainty, first, statistical, unsanitized)

}  // namespace test_wave_uncertainty

#include "test_wave_uncertainty.moc"
