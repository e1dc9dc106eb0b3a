#include "core/resonator/fit/pencil_start.h"
#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/test_registry.h"

namespace test_delayed_pencil {

using namespace vybeg;
using namespace vybeg::test;

namespace {

// A bell's pair before two microphones that hear nearly the same mixture: the second principal
// direction has 1e-4 of the power.
PhasorRun two_microphones(double noise) {
    FreeDecay bell = reference();
    bell.seconds = 4;
    bell.rate_hz = 44100;
    bell.f0_hz = 3618;
    bell.split_hz = 5.6;
    bell.tau_s = 0.83;
    bell.noise = noise;
    PhasorRun run = simulated_phasors(
        [&] {
            FreeDecay struck = bell;
            struck.two_theta_A = 0.7;
            return struck;
        }(),
        600, 3);
    for (std::size_t k = 0; k < run.c.size(); ++k) {
        const auto both = run.c[k] + run.d[k];
        run.d[k] = both + std::complex(0.01, 0.01) * run.d[k];
        run.c[k] = both;
    }
    return run;
}

}  // namespace

class TestDelayedPencil : public QObject {
    Q_OBJECT

private slots:
    void nearlyEqualChannelsGiveBothModes() {
        const ScaledRun run = scaled_run(two_microphones(0.03), 1);
        const std::optional<SlowRates> rates = delayed_pencil(run, run.z, 2);
        QVERIFY(rates.has_value());
        const SlowDynamics motion(*rates);
        const double split = std::abs(motion.half_difference().imag()) / std::numbers::pi;
        VYBEG_CLOSE(split, 5.6, 0.02);
        VYBEG_CLOSE((*rates)[decay_at] * 0.83, 1, 0.05);
    }

    void theFitFindsThem() {
        const ResonatorFit fit =
            fitted({two_microphones(0.03)}, {.model = FitOptions::Model::free});
        VYBEG_EQUAL(fit.modes.size(), 2,
                    qPrintable(QString("chi^2/dof %1: %2")
                                   .arg(fit.chi2_per_dof)
                                   .arg(english(fit.no_modes).c_str())));
        // Both channels share most of their noise here, which the deviations take as colour.
        VYBEG_NEAR(fit.modes[0].f_hz, 3618 + 2.8, 4, 3e-2);
        VYBEG_NEAR(fit.modes[1].f_hz, 3618 - 2.8, 4, 3e-2);
        VYBEG_NEAR(fit.modes[0].tau_s, 0.83, 4, 0.2);
    }

    void tooFewWindowsGiveNothing() {
        const ScaledRun run = scaled_run(two_microphones(0.03), 1);
        QVERIFY(!delayed_pencil(run, run.z, run.size()).has_value());
    }
};

VYBEG_TEST(TestDelayedPencil)

}  // namespace test_delayed_pencil

#include "test_delayed_pencil.moc"
