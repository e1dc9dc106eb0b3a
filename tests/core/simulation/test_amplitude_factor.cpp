// Friction and drive against their solutions in closed form.
#include "core/simulation/decay_motion.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>

namespace test_amplitude_factor {

using namespace vybeg;

namespace {

FreeDecay decay_of(double tau_s) {
    FreeDecay decay{.seconds = 20,
                    .rate_hz = 1000,
                    .f0_hz = 210,
                    .split_hz = 0.1,
                    .tau_s = tau_s,
                    .omega_rad_s = 0.1};
    return decay;
}

// |z| at t.
double amplitude(const FreeDecay& decay, double t) {
    DecayMotion motion(decay);
    return motion.at_frame(t * decay.rate_hz).norm();
}

}  // namespace

class TestAmplitudeFactor : public QObject {
    Q_OBJECT

private slots:
    void dry_friction_ends_in_rest() {
        constexpr double k = 0.07;
        constexpr double tau = 15;
        FreeDecay decay = decay_of(tau);
        decay.dry_friction_per_s = k;
        for (const double t : {0.5, 3.0, 8.0}) {
            VYBEG_CLOSE(amplitude(decay, t), (1 + k * tau) * std::exp(-t / tau) - k * tau, 1e-9);
        }
        const double rest = tau * std::log(1 + 1 / (k * tau));
        QCOMPARE(amplitude(decay, rest + 0.1), 0.0);
        decay.tau_s = 1e300;
        VYBEG_CLOSE(amplitude(decay, 10), 1 - 10 * k, 1e-9);
    }

    void friction_of_air_follows_the_amplitude() {
        constexpr double k = 0.4;
        constexpr double tau = 15;
        FreeDecay decay = decay_of(tau);
        decay.air_friction_per_s = k;
        for (const double t : {0.5, 3.0, 18.0}) {
            VYBEG_CLOSE(amplitude(decay, t), 1 / ((1 + k * tau) * std::exp(t / tau) - k * tau),
                        1e-9);
        }
    }

    void a_drive_acts_between_its_instants() {
        FreeDecay decay = decay_of(10);
        decay.drive_per_s = 0.1;
        decay.drive_from_s = 2;
        decay.drive_to_s = 7;
        VYBEG_CLOSE(amplitude(decay, 2), std::exp(-0.2), 1e-9);
        VYBEG_CLOSE(amplitude(decay, 5), std::exp(-0.2), 1e-9);
        VYBEG_CLOSE(amplitude(decay, 12), std::exp(-0.7), 1e-9);
    }

    void the_shape_of_the_wave_stays() {
        FreeDecay decay = decay_of(10);
        DecayMotion linear(decay);
        decay.air_friction_per_s = 1;
        DecayMotion damped(decay);
        for (const double frame : {100.0, 5000.5, 19000.0}) {
            const Eigen::Vector2cd z = linear.at_frame(frame);
            const Eigen::Vector2cd y = damped.at_frame(frame);
            VYBEG_CLOSE((z / z.norm() - y / y.norm()).norm(), 0, 1e-12);
            VYBEG_LESS(y.norm(), 0.95 * z.norm());
        }
    }
};

VYBEG_TEST(TestAmplitudeFactor)

}  // namespace test_amplitude_factor

#include "test_amplitude_factor.moc"
