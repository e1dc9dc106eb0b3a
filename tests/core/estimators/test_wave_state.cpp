#include "core/estimators/wave/wave_state.h"
#include "core/numerics/phase.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <numbers>

namespace test_wave_state {

using namespace vybeg;

namespace {

constexpr double pi = std::numbers::pi;

// C and D at one phase of the carrier, from (6).
std::pair<double, double> displacement(const WaveState& s, double carrier) {
    const double a = s.a_A * std::cos(carrier - s.alpha);
    const double b = s.a_B * std::sin(carrier - s.alpha);
    return {a * std::cos(s.two_theta_A) - b * std::sin(s.two_theta_A),
            a * std::sin(s.two_theta_A) + b * std::cos(s.two_theta_A)};
}

}  // namespace

class TestWaveState : public QObject {
    Q_OBJECT

private slots:
    void phasorsGiveTheMotionOfEquation6() {
        for (double angle = -3; angle < 3.2; angle += 0.37) {
            for (const double a_B : {-0.7, 0.0, 0.2}) {
                const WaveState state{1.2, a_B, angle, 1.7 * angle};
                const Phasors phasors = to_phasors(state);
                for (double carrier = 0; carrier < 6; carrier += 0.9) {
                    const auto wave = std::polar(1.0, carrier);
                    const auto [c, d] = displacement(state, carrier);
                    VYBEG_CLOSE((phasors.c * wave).real(), c, 1e-14);
                    VYBEG_CLOSE((phasors.d * wave).real(), d, 1e-14);
                }
            }
        }
    }

    void inversionReturnsTheSameMotionInItsCanonicalForm() {
        // Every quarter of both angles, the axes themselves, a_B of both signs and above a_A.
        for (int quarter = -8; quarter <= 8; ++quarter) {
            for (const double aside : {-1e-9, 0.0, 1e-9, 0.3}) {
                for (const double alpha : {-pi, -2.0, 0.0, 0.5, 3.0}) {
                    for (const double a_B : {-1.4, -0.9, -1e-7, 0.0, 0.5, 1.1}) {
                        const WaveState given{1, a_B, quarter * pi / 4 + aside, alpha};
                        const WaveState found = to_wave_state(to_phasors(given));
                        VYBEG_WITHIN(found.a_B, 0, found.a_A);
                        VYBEG_MORE(found.two_theta_A, -pi / 2);
                        VYBEG_AT_MOST(found.two_theta_A, pi / 2);
                        VYBEG_MORE(found.alpha, -pi);
                        VYBEG_AT_MOST(found.alpha, pi);
                        for (double carrier = 0; carrier < 6; carrier += 0.9) {
                            const auto [c, d] = displacement(given, carrier);
                            const auto [c_found, d_found] = displacement(found, carrier);
                            VYBEG_CLOSE(c, c_found, 1e-14);
                            VYBEG_CLOSE(d, d_found, 1e-14);
                        }
                    }
                }
            }
        }
    }

    void productOfAmplitudesHasTheCorrectedSign() {
        // METHOD section 2: a_A a_B = -a_C a_D sin dphi_CD, and Im(c conj d).
        for (const double a_B : {-0.6, -0.1, 0.3, 0.8}) {
            for (double angle = -1.5; angle < 1.6; angle += 0.25) {
                const WaveState state{1.1, a_B, angle, 0.9};
                const Phasors p = to_phasors(state);
                const double product =
                    -std::abs(p.c) * std::abs(p.d) * std::sin(phase_difference(p));
                VYBEG_CLOSE(product, 1.1 * a_B, 1e-14);
                VYBEG_CLOSE((p.c * std::conj(p.d)).imag(), 1.1 * a_B, 1e-14);
            }
        }
    }
};

VYBEG_TEST(TestWaveState)

}  // namespace test_wave_state

#include "test_wave_state.moc"
