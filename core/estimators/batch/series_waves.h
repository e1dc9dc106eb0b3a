#pragma once

#include "core/estimators/batch/lanes.h"
#include "core/estimators/batch/series_result.h"
#include "core/estimators/batch/window_series.h"

#include <cmath>
#include <numbers>

// For sources that are VYBEG_DISPATCHED: from the phasors of eight windows to all that is said of
// them.

// glibc has this for whole vectors (libmvec, to four units of the last place), but tells the
// compiler so only under -ffast-math.
#ifndef __clang__
extern "C" {
__attribute__((simd("notinbranch"), const)) double atan2(double y, double x) noexcept;
}
#endif

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace vybeg {

VYBEG_INLINED inline Eight atan2_of(Eight y, Eight x) {
    Lanes ys;
    Lanes xs;
    store(y, ys);
    store(x, xs);
    for (std::size_t lane = 0; lane < series_lanes; ++lane) {
        ys[lane] = ::atan2(ys[lane], xs[lane]);
    }
    return load(ys);
}

// gram_cos at x, with its derivatives by x.
VYBEG_INLINED inline Bent gram_at(const SeriesFrame& frame, Eight x) {
    const auto& gram = frame.gram();
    return series_at<SeriesFrame::gram_orders>(
        x, [&gram](std::size_t k) VYBEG_INLINED { return gram[k] + Eight{}; });
}

VYBEG_INLINED inline Eight projection_at(const std::array<Lanes, series_orders>& sums, Eight x) {
    return polynomial<series_orders>(x, [&](std::size_t k) VYBEG_INLINED { return load(sums[k]); });
}

// Phasors c = c_re + i c_im and so on.
struct PhasorLanes {
    Eight c_re;
    Eight c_im;
    Eight d_re;
    Eight d_im;
};

struct StateLanes {
    Eight a_A;
    Eight a_B;
    Eight two_theta_A;
    Eight alpha;
    // cos and sin of twice two_theta_A.
    Eight turn_cos;
    Eight turn_sin;
};

// Into 2theta_A in (-pi/2, pi/2] and alpha in (-pi, pi], together: lower edges belong to the upper
// ones.
VYBEG_INLINED inline void make_canonical(Eight& two_theta_A, Eight& alpha) {
    constexpr double pi = std::numbers::pi;
    constexpr double least = 1e-300;
    const Eight turn = if_negative(two_theta_A + pi / 2 - least, Eight{} + pi, Eight{});
    two_theta_A += turn;
    alpha += turn;
    alpha = if_negative(pi - alpha, alpha - 2 * pi, alpha);
    alpha = if_negative(alpha + pi - least, alpha + 2 * pi, alpha);
}

// wave_state.h: the travelling waves u+ = c + i d and u- = c - i d have the moduli a_A + a_B and
// a_A - a_B, the phases 2theta_A - alpha and -2theta_A - alpha.
VYBEG_INLINED inline StateLanes state_of(const PhasorLanes& z) {
    const Eight p_re = z.c_re - z.d_im;
    const Eight p_im = z.c_im + z.d_re;
    const Eight m_re = z.c_re + z.d_im;
    const Eight m_im = z.c_im - z.d_re;
    const Eight p = sqrt_of(p_re * p_re + p_im * p_im);
    const Eight m = sqrt_of(m_re * m_re + m_im * m_im);
    // u+ conj u-, which turns by 4theta_A.
    const Eight turn_re = p_re * m_re + p_im * m_im;
    const Eight turn_im = p_im * m_re - p_re * m_im;
    Eight angle = 0.5 * atan2_of(turn_im, turn_re);
    Eight alpha = angle - atan2_of(p_im, p_re);
    make_canonical(angle, alpha);
    const Eight by_moduli = 1 / (p * m);
    return {0.5 * (p + m), 0.5 * (p - m), angle, alpha, turn_re * by_moduli, turn_im * by_moduli};
}

// precision_bound.h and (30) for all lanes, and everything into `estimates`.
VYBEG_INLINED inline void complete_lanes(const SeriesBatch& batch, const SeriesFrame& frame,
                                         Eight x, const Bent& g_cos, const PhasorLanes& z,
                                         const StateLanes& state, SeriesEstimates& estimates) {
    const auto n = static_cast<double>(frame.length());
    const double spread = frame.spread();
    const Eight by_cos = 1 / g_cos.value;
    const Eight by_sin = 1 / (n - g_cos.value);
    const Eight slope = 0.5 * n * g_cos.slope;
    const Eight bend = 0.25 * n * n * g_cos.bend;
    const Eight k0 = 0.5 * z.c_re * slope * by_cos;
    const Eight k1 = -0.5 * z.c_im * slope * by_sin;
    const Eight k2 = 0.5 * z.d_re * slope * by_cos;
    const Eight k3 = -0.5 * z.d_im * slope * by_sin;
    const Eight with_cos = 0.5 * (spread + 0.5 * bend);
    const Eight with_sin = 0.5 * (spread - 0.5 * bend);
    const Eight information = (z.c_re * z.c_re + z.d_re * z.d_re) * with_cos +
                              (z.c_im * z.c_im + z.d_im * z.d_im) * with_sin -
                              0.5 * slope * (z.c_re * k0 - z.c_im * k1 + z.d_re * k2 - z.d_im * k3);
    const Eight by_information = 1 / information;
    const auto sd = [&](Eight g0, Eight g1, Eight g2, Eight g3) VYBEG_INLINED {
        const Eight own = (g0 * g0 + g2 * g2) * by_cos + (g1 * g1 + g3 * g3) * by_sin;
        const Eight through = g0 * k0 + g1 * k1 + g2 * k2 + g3 * k3;
        return sqrt_of(own + through * through * by_information);
    };
    // Gradients by (Re c, Im c, Re d, Im d): those of a_A and a_B are half the sum and half the
    // difference of |u+|'s and |u-|'s, those of the angles likewise of the phases'.
    const Eight p_re = z.c_re - z.d_im;
    const Eight p_im = z.c_im + z.d_re;
    const Eight m_re = z.c_re + z.d_im;
    const Eight m_im = z.c_im - z.d_re;
    const Eight p2 = p_re * p_re + p_im * p_im;
    const Eight m2 = m_re * m_re + m_im * m_im;
    const Eight half_by_p = 0.5 / sqrt_of(p2);
    const Eight half_by_m = 0.5 / sqrt_of(m2);
    const Eight p_r = p_re * half_by_p;
    const Eight p_i = p_im * half_by_p;
    const Eight m_r = m_re * half_by_m;
    const Eight m_i = m_im * half_by_m;
    store(sd(p_r + m_r, p_i + m_i, p_i - m_i, m_r - p_r), estimates.sd_a_A);
    store(sd(p_r - m_r, p_i - m_i, p_i + m_i, -m_r - p_r), estimates.sd_a_B);
    const Eight qr = 2 * p_r * half_by_p;
    const Eight qi = 2 * p_i * half_by_p;
    const Eight nr = 2 * m_r * half_by_m;
    const Eight ni = 2 * m_i * half_by_m;
    store(sd(ni - qi, qr - nr, qr + nr, qi + ni), estimates.sd_two_theta_A);
    store(sd(qi + ni, -qr - nr, nr - qr, ni - qi), estimates.sd_alpha);
    const Eight by_c2 = 1 / (z.c_re * z.c_re + z.c_im * z.c_im);
    const Eight by_d2 = 1 / (z.d_re * z.d_re + z.d_im * z.d_im);
    store(sd(z.c_im * by_c2, -z.c_re * by_c2, -z.d_im * by_d2, z.d_re * by_d2),
          estimates.sd_delta_phi_CD);
    store(sqrt_of(by_information), estimates.sd_w);

    store(frame.w0() + 2 * x / n, estimates.w);
    store(z.c_re, estimates.c_re);
    store(z.c_im, estimates.c_im);
    store(z.d_re, estimates.d_re);
    store(z.d_im, estimates.d_im);
    store(state.a_A, estimates.a_A);
    store(state.a_B, estimates.a_B);
    store(state.two_theta_A, estimates.two_theta_A);
    store(state.alpha, estimates.alpha);
    store(atan2_of(z.d_im * z.c_re - z.d_re * z.c_im, z.d_re * z.c_re + z.d_im * z.c_im),
          estimates.delta_phi_CD);
    store((load(batch.cd) * state.turn_cos +
           0.5 * (load(batch.dd) - load(batch.cc)) * state.turn_sin) /
              (load(batch.cc) + load(batch.dd)),
          estimates.orthogonality);
}

}  // namespace vybeg

#pragma GCC diagnostic pop
