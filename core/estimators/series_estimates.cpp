#include "core/estimators/series_estimates.h"

#include "core/estimators/lanes.h"

#include <cmath>
#include <numbers>

// glibc has this for whole vectors (libmvec, to four units of the last place), but tells the
// compiler so only under -ffast-math.
#ifndef __clang__
extern "C" {
__attribute__((simd("notinbranch"), const)) double atan2(double y, double x) noexcept;
}
#endif

namespace vybeg {
namespace {

// As in lanes.h.
#pragma GCC diagnostic ignored "-Wpsabi"

constexpr double pi = std::numbers::pi;

VYBEG_INLINED inline Eight sqrt_of(Eight x) {
    Eight root;
    for (std::size_t lane = 0; lane < series_lanes; ++lane) {
        root[lane] = std::sqrt(x[lane]);
    }
    return root;
}

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

}  // namespace

VYBEG_DISPATCHED
void series_estimates(const SeriesBatch& __restrict batch, const SeriesMaximum& __restrict maximum,
                      const SeriesBasis& __restrict basis, SeriesEstimates& __restrict estimates) {
    const auto n = static_cast<double>(basis.length());
    const double spread = basis.spread();
    const auto& gram = basis.gram();
    const Eight x = load(maximum.x);
    const auto at = [x](const std::array<Lanes, series_orders>& sums) VYBEG_INLINED {
        return polynomial<series_orders>(
            x, [&](std::size_t k) VYBEG_INLINED { return load(sums[k]); });
    };
    const Bent g_cos = series_at<SeriesBasis::gram_orders>(
        x, [&](std::size_t k) VYBEG_INLINED { return gram[k] + Eight{}; });
    const Eight by_cos = 1 / g_cos.value;
    const Eight by_sin = 1 / (n - g_cos.value);
    const Eight slope = 0.5 * n * g_cos.slope;
    const Eight bend = 0.25 * n * n * g_cos.bend;

    const Eight c_re = at(batch.c_cos) * by_cos;
    const Eight c_im = -at(batch.c_sin) * by_sin;
    const Eight d_re = at(batch.d_cos) * by_cos;
    const Eight d_im = -at(batch.d_sin) * by_sin;

    // The travelling waves u+ = c + i d and u- = c - i d (METHOD section 1): their moduli are
    // a_A + a_B and a_A - a_B, their phases 2theta_A - alpha and -2theta_A - alpha.
    const Eight p_re = c_re - d_im;
    const Eight p_im = c_im + d_re;
    const Eight m_re = c_re + d_im;
    const Eight m_im = c_im - d_re;
    const Eight p2 = p_re * p_re + p_im * p_im;
    const Eight m2 = m_re * m_re + m_im * m_im;
    const Eight p = sqrt_of(p2);
    const Eight m = sqrt_of(m2);
    // |u+||u-| times cos and sin of 4theta_A, in twice the wave's angle.
    const Eight turn_re = p_re * m_re + p_im * m_im;
    const Eight turn_im = p_im * m_re - p_re * m_im;
    Eight angle = 0.5 * atan2_of(turn_im, turn_re);
    // 2theta_A in (-pi/2, pi/2] and alpha in (-pi, pi]: the lower edges belong to the upper ones.
    constexpr double least = 1e-300;
    angle = if_negative(angle + pi / 2 - least, angle + pi, angle);
    Eight alpha = angle - atan2_of(p_im, p_re);
    alpha = if_negative(pi - alpha, alpha - 2 * pi, alpha);
    alpha = if_negative(alpha + pi - least, alpha + 2 * pi, alpha);

    // Precision bound: gradients by (Re c, Im c, Re d, Im d), of which those of a_A and a_B are
    // half the sum and half the difference of |u+|'s and |u-|'s, those of the angles likewise
    // of the phases'.
    const Eight k0 = 0.5 * c_re * slope * by_cos;
    const Eight k1 = -0.5 * c_im * slope * by_sin;
    const Eight k2 = 0.5 * d_re * slope * by_cos;
    const Eight k3 = -0.5 * d_im * slope * by_sin;
    const Eight with_cos = 0.5 * (spread + 0.5 * bend);
    const Eight with_sin = 0.5 * (spread - 0.5 * bend);
    const Eight information = (c_re * c_re + d_re * d_re) * with_cos +
                              (c_im * c_im + d_im * d_im) * with_sin -
                              0.5 * slope * (c_re * k0 - c_im * k1 + d_re * k2 - d_im * k3);
    const Eight by_information = 1 / information;
    const auto sd = [&](Eight g0, Eight g1, Eight g2, Eight g3) VYBEG_INLINED {
        const Eight own = (g0 * g0 + g2 * g2) * by_cos + (g1 * g1 + g3 * g3) * by_sin;
        const Eight through = g0 * k0 + g1 * k1 + g2 * k2 + g3 * k3;
        return sqrt_of(own + through * through * by_information);
    };
    const Eight p_r = 0.5 * p_re / p;
    const Eight p_i = 0.5 * p_im / p;
    const Eight m_r = 0.5 * m_re / m;
    const Eight m_i = 0.5 * m_im / m;
    store(sd(p_r + m_r, p_i + m_i, p_i - m_i, m_r - p_r), estimates.sd_a_A);
    store(sd(p_r - m_r, p_i - m_i, p_i + m_i, -m_r - p_r), estimates.sd_a_B);
    const Eight qr = 0.5 * p_re / p2;
    const Eight qi = 0.5 * p_im / p2;
    const Eight nr = 0.5 * m_re / m2;
    const Eight ni = 0.5 * m_im / m2;
    store(sd(ni - qi, qr - nr, qr + nr, qi + ni), estimates.sd_two_theta_A);
    store(sd(qi + ni, -qr - nr, nr - qr, ni - qi), estimates.sd_alpha);
    const Eight c2 = c_re * c_re + c_im * c_im;
    const Eight d2 = d_re * d_re + d_im * d_im;
    store(sd(c_im / c2, -c_re / c2, -d_im / d2, d_re / d2), estimates.sd_delta_phi_CD);
    store(sqrt_of(by_information), estimates.sd_w);

    store(basis.w0() + 2 * x / n, estimates.w);
    store(c_re, estimates.c_re);
    store(c_im, estimates.c_im);
    store(d_re, estimates.d_re);
    store(d_im, estimates.d_im);
    store(0.5 * (p + m), estimates.a_A);
    store(0.5 * (p - m), estimates.a_B);
    store(angle, estimates.two_theta_A);
    store(alpha, estimates.alpha);
    store(atan2_of(d_im * c_re - d_re * c_im, d_re * c_re + d_im * c_im), estimates.delta_phi_CD);
    store((load(batch.cd) * turn_re + 0.5 * (load(batch.dd) - load(batch.cc)) * turn_im) /
              (p * m * (load(batch.cc) + load(batch.dd))),
          estimates.orthogonality);
}

}  // namespace vybeg
