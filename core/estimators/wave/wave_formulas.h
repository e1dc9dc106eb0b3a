#pragma once

#include "core/estimators/wave/lanes.h"
#include "core/estimators/wave/wave_state.h"

#include <numbers>

// The formulas of METHOD section 1 in both widths.

namespace vybeg {

// Phasors c = c_re + i c_im and so on.
template <class Real>
struct PhasorParts {
    Real c_re;
    Real c_im;
    Real d_re;
    Real d_im;
};

inline PhasorParts<double> parts_of(const Phasors& z) {
    return {z.c.real(), z.c.imag(), z.d.real(), z.d.imag()};
}

// cos and sin of 2theta_A and alpha beside the amplitudes.
template <class Real>
struct TurnedWave {
    Real a_A;
    Real a_B;
    Real cos_angle;
    Real sin_angle;
    Real cos_phase;
    Real sin_phase;
};

inline TurnedWave<double> turned(const WaveState& state) {
    return {state.a_A,
            state.a_B,
            std::cos(state.two_theta_A),
            std::sin(state.two_theta_A),
            std::cos(state.alpha),
            std::sin(state.alpha)};
}

// e^{-i alpha} (a_A cos 2theta_A + i a_B sin 2theta_A) and so on.
template <class Real>
VYBEG_INLINED inline PhasorParts<Real> phasors_of(const TurnedWave<Real>& wave) {
    const Real c_re = wave.a_A * wave.cos_angle;
    const Real c_im = wave.a_B * wave.sin_angle;
    const Real d_re = wave.a_A * wave.sin_angle;
    const Real d_im = -wave.a_B * wave.cos_angle;
    return {wave.cos_phase * c_re + wave.sin_phase * c_im,
            wave.cos_phase * c_im - wave.sin_phase * c_re,
            wave.cos_phase * d_re + wave.sin_phase * d_im,
            wave.cos_phase * d_im - wave.sin_phase * d_re};
}

// A wave, and cos and sin of twice its two_theta_A.
template <class Real>
struct OrientedWave {
    WaveStateOf<Real> wave;
    Real turn_cos;
    Real turn_sin;
};

// An angle in [-pi, pi] or just outside into (-pi, pi]: the lower edge belongs to the upper one.
template <class Real>
VYBEG_INLINED inline Real upper_edge(Real angle) {
    constexpr double pi = std::numbers::pi;
    constexpr double least = 1e-300;
    return select(negative(angle + pi - least), angle + 2 * pi, angle);
}

// Into 2theta_A in (-pi/2, pi/2] and alpha in (-pi, pi], together.
template <class Real>
VYBEG_INLINED inline void make_canonical(Real& two_theta_A, Real& alpha) {
    constexpr double pi = std::numbers::pi;
    constexpr double least = 1e-300;
    const Real turn = select(negative(two_theta_A + pi / 2 - least), Real{} + pi, Real{});
    two_theta_A += turn;
    alpha += turn;
    alpha = upper_edge(select(negative(pi - alpha), alpha - 2 * pi, alpha));
}

// The travelling waves u+ = c + i d and u- = c - i d have the moduli a_A + a_B and a_A - a_B, the
// phases 2theta_A - alpha and -2theta_A - alpha.
template <class Real>
VYBEG_INLINED inline OrientedWave<Real> state_of(const PhasorParts<Real>& z) {
    const Real p_re = z.c_re - z.d_im;
    const Real p_im = z.c_im + z.d_re;
    const Real m_re = z.c_re + z.d_im;
    const Real m_im = z.c_im - z.d_re;
    const Real p = sqrt_of(p_re * p_re + p_im * p_im);
    const Real m = sqrt_of(m_re * m_re + m_im * m_im);
    // u+ conj u-, which turns by 4theta_A.
    const Real turn_re = p_re * m_re + p_im * m_im;
    const Real turn_im = p_im * m_re - p_re * m_im;
    Real angle = 0.5 * atan2_of(turn_im, turn_re);
    Real alpha = angle - atan2_of(p_im, p_re);
    make_canonical(angle, alpha);
    const Real by_moduli = 1 / (p * m);
    return {{0.5 * (p + m), 0.5 * (p - m), angle, alpha}, turn_re * by_moduli, turn_im * by_moduli};
}

// phase_difference() of wave_state.h.
template <class Real>
VYBEG_INLINED inline Real phase_difference_of(const PhasorParts<Real>& z) {
    return upper_edge(
        atan2_of(z.d_im * z.c_re - z.d_re * z.c_im, z.d_re * z.c_re + z.d_im * z.c_im));
}

}  // namespace vybeg
