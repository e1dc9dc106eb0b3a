#pragma once

#include "core/estimators/wave/wave_state.h"
#include "core/estimators/wave/window_moments.h"
#include "core/numerics/lanes.h"

#include <cstdint>
#include <numbers>

// The formulas of METHOD section 1 in both widths, and the bound of a window's uncertainty.

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

// Lower bounds of the standard deviations of unbiased estimators in one window, in white noise.
template <class Real>
struct PrecisionOf {
    WaveStateOf<Real> sd;  // recording units and rad
    Real w{};              // rad per sample
    Real delta_phi_CD{};
};

// Cramer-Rao bound of all five parameters together for noise of one recording unit per sample and
// channel, for the actual window: it keeps the terms of the residual of METHOD section 3, which
// section 6 omits, and equals section 6 at zero residual (tested). The bounds of the angles are not
// finite at a_A = |a_B|.
template <class Real>
VYBEG_INLINED inline PrecisionOf<Real> unit_precision(const PhasorParts<Real>& z,
                                                      const WindowKernelOf<Real>& kernel) {
    // Fisher information of (phasors, w): the phasors' block is diagonal because time is centred.
    // The samples' derivative by w is -u (Re c sin wu + Im c cos wu). With sum u sin 2wu = -slope
    // and sum u^2 cos 2wu = -bend/2, each k is the information shared by w and one phasor
    // component, divided by that component's own.
    const Real slope = kernel.slope;
    const Real by_cos = 1 / kernel.gram_cos;
    const Real by_sin = 1 / kernel.gram_sin;
    const Real k0 = 0.5 * z.c_re * slope * by_cos;
    const Real k1 = -0.5 * z.c_im * slope * by_sin;
    const Real k2 = 0.5 * z.d_re * slope * by_cos;
    const Real k3 = -0.5 * z.d_im * slope * by_sin;
    const Real with_cos = 0.5 * (kernel.spread + 0.5 * kernel.bend);
    const Real with_sin = 0.5 * (kernel.spread - 0.5 * kernel.bend);
    const Real information = (z.c_re * z.c_re + z.d_re * z.d_re) * with_cos +
                             (z.c_im * z.c_im + z.d_im * z.d_im) * with_sin -
                             0.5 * slope * (z.c_re * k0 - z.c_im * k1 + z.d_re * k2 - z.d_im * k3);
    const Real by_information = 1 / information;
    const auto sd = [&](Real g0, Real g1, Real g2, Real g3) VYBEG_INLINED {
        const Real own = (g0 * g0 + g2 * g2) * by_cos + (g1 * g1 + g3 * g3) * by_sin;
        const Real through = g0 * k0 + g1 * k1 + g2 * k2 + g3 * k3;
        return sqrt_of(own + through * through * by_information);
    };
    // Gradients by (Re c, Im c, Re d, Im d): those of a_A and a_B are half the sum and half the
    // difference of |u+|'s and |u-|'s, those of the angles likewise of the phases'.
    const Real p_re = z.c_re - z.d_im;
    const Real p_im = z.c_im + z.d_re;
    const Real m_re = z.c_re + z.d_im;
    const Real m_im = z.c_im - z.d_re;
    const Real half_by_p = 0.5 / sqrt_of(p_re * p_re + p_im * p_im);
    const Real half_by_m = 0.5 / sqrt_of(m_re * m_re + m_im * m_im);
    const Real p_r = p_re * half_by_p;
    const Real p_i = p_im * half_by_p;
    const Real m_r = m_re * half_by_m;
    const Real m_i = m_im * half_by_m;
    const Real qr = 2 * p_r * half_by_p;
    const Real qi = 2 * p_i * half_by_p;
    const Real nr = 2 * m_r * half_by_m;
    const Real ni = 2 * m_i * half_by_m;
    const Real by_c2 = 1 / (z.c_re * z.c_re + z.c_im * z.c_im);
    const Real by_d2 = 1 / (z.d_re * z.d_re + z.d_im * z.d_im);
    return {{sd(p_r + m_r, p_i + m_i, p_i - m_i, m_r - p_r),
             sd(p_r - m_r, p_i - m_i, p_i + m_i, -m_r - p_r),
             sd(ni - qi, qr - nr, qr + nr, qi + ni), sd(qi + ni, -qr - nr, nr - qr, ni - qi)},
            sqrt_of(by_information),
            sd(z.c_im * by_c2, -z.c_re * by_c2, -z.d_im * by_d2, z.d_re * by_d2)};
}

// The same for white noise of the phasors and of the frequency; `hertz`: of one rad per sample.
inline WaveErrors errors_of(const PrecisionOf<double>& unit, double phasors, double frequency,
                            double hertz) {
    return {{phasors * unit.sd.a_A, phasors * unit.sd.a_B, phasors * unit.sd.two_theta_A,
             phasors * unit.sd.alpha},
            frequency * unit.w * hertz,
            phasors * unit.delta_phi_CD};
}

// The same for a window of n samples at f_hz and noise of noise_sd recording units.
inline WaveErrors precision_bound(const Phasors& phasors, double f_hz, double rate_hz,
                                  std::int64_t n, double noise_sd) {
    const double hertz = rate_hz / (2 * std::numbers::pi);
    return errors_of(unit_precision(parts_of(phasors), window_kernel(n, f_hz / hertz)), noise_sd,
                     noise_sd, hertz);
}

}  // namespace vybeg
