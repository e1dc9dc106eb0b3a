#include "core/estimators/wave/wave_state.h"

#include "core/numerics/phase.h"

#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
constexpr Complex i{0, 1};

}  // namespace

WaveState to_wave_state(const Phasors& phasors) {
    const Complex plus = phasors.c + i * phasors.d;
    const Complex minus = phasors.c - i * phasors.d;
    WaveState state;
    state.a_A = (std::abs(plus) + std::abs(minus)) / 2;
    state.a_B = (std::abs(plus) - std::abs(minus)) / 2;
    state.two_theta_A = std::arg(plus * std::conj(minus)) / 2;
    if (state.two_theta_A <= -std::numbers::pi / 2) {  // arg may return -pi for a negative zero
        state.two_theta_A = std::numbers::pi / 2;
    }
    // The angle first, then the phase of the wave along it: only so are both of one motion.
    state.alpha = -std::arg(phasors.c * std::cos(state.two_theta_A) +
                            phasors.d * std::sin(state.two_theta_A));
    state.alpha = wrap(state.alpha);
    return state;
}

Phasors to_phasors(const WaveState& state) {
    const double cosine = std::cos(state.two_theta_A);
    const double sine = std::sin(state.two_theta_A);
    const Complex turn = std::polar(1.0, -state.alpha);
    return {turn * Complex{state.a_A * cosine, state.a_B * sine},
            turn * Complex{state.a_A * sine, -state.a_B * cosine}};
}

WaveState canonical(const WaveState& state) {
    return to_wave_state(to_phasors(state));
}

double phase_difference(const Phasors& phasors) {
    return wrap(std::arg(phasors.d * std::conj(phasors.c)));
}

}  // namespace vybeg
