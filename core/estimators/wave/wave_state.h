#pragma once

#include <complex>

namespace vybeg {

// Complex amplitudes of the pick-off signals: C = Re(c e^{i w t}), D = Re(d e^{i w t}) (METHOD
// section 1).
struct Phasors {
    std::complex<double> c;
    std::complex<double> d;

    friend bool operator==(const Phasors&, const Phasors&) = default;
};

// The standing waves: amplitudes (a_A >= |a_B|, a_B signed) in recording units, angles in rad.
template <class Real>
struct WaveStateOf {
    Real a_A{};
    Real a_B{};
    Real two_theta_A{};
    Real alpha{};

    friend bool operator==(const WaveStateOf&, const WaveStateOf&) = default;
};
using WaveState = WaveStateOf<double>;

// Errors of a wave and its frequency: standard deviations, or differences.
struct WaveErrors : WaveState {
    double f_hz = 0;
    double delta_phi_CD = 0;  // rad
};

// The inversion of METHOD section 1. two_theta_A lies in (-pi/2, pi/2] and alpha in (-pi, pi],
// chosen together. At a_A = |a_B| the angles are undefined; the caller checks the amplitudes.
WaveState to_wave_state(const Phasors& phasors);

Phasors to_phasors(const WaveState& state);

// arg(d conj c) = phi_C - phi_D, in (-pi, pi]; its sine has the sign of -a_A a_B.
double phase_difference(const Phasors& phasors);

}  // namespace vybeg
