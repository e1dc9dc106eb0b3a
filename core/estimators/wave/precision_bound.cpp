#include "core/estimators/wave/precision_bound.h"

#include "core/estimators/wave/window_moments.h"

#include <array>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Gradient = std::array<double, 4>;  // by Re c, Im c, Re d, Im d

// Derivatives of |x| and arg x by Re and Im of each phasor, where x = c_factor c + d_factor d.
struct Polar {
    Gradient modulus;
    Gradient argument;
};

Polar polar_gradient(Complex x, Complex c_factor, Complex d_factor) {
    const std::array<Complex, 4> change{c_factor, Complex{0, 1} * c_factor, d_factor,
                                        Complex{0, 1} * d_factor};
    Polar polar{};
    for (std::size_t k = 0; k < 4; ++k) {
        const Complex along = change[k] * std::conj(x);
        polar.modulus[k] = along.real() / std::abs(x);
        polar.argument[k] = along.imag() / std::norm(x);
    }
    return polar;
}

Gradient combine(const Gradient& a, double a_factor, const Gradient& b, double b_factor) {
    Gradient sum{};
    for (std::size_t k = 0; k < 4; ++k) {
        sum[k] = a_factor * a[k] + b_factor * b[k];
    }
    return sum;
}

}  // namespace

Precision precision_bound(const Phasors& phasors, double f_hz, double rate_hz, std::int64_t n,
                          double noise_sd) {
    const double w = 2 * std::numbers::pi * f_hz / rate_hz;
    return precision_bound(phasors, window_kernel(n, w), rate_hz, noise_sd);
}

Precision precision_bound(const Phasors& phasors, const WindowKernel& kernel, double rate_hz,
                          double noise_sd) {
    const Gradient v{phasors.c.real(), phasors.c.imag(), phasors.d.real(), phasors.d.imag()};
    const Gradient gram{kernel.gram_cos, kernel.gram_sin, kernel.gram_cos, kernel.gram_sin};

    // Fisher information of (phasors, w): the phasors' block is diagonal because time is centred.
    // The samples' derivative by w is -u (Re c sin wu + Im c cos wu). With sum u sin 2wu = -slope
    // and sum u^2 cos 2wu = -bend/2:
    double information_w = 0;
    Gradient coupling{};  // Fisher element between w and each phasor component, over its gram
    for (std::size_t k = 0; k < 4; ++k) {
        const bool cosine = k % 2 == 0;
        const double cross = (cosine ? 0.5 : -0.5) * v[k] * kernel.slope;
        coupling[k] = cross / gram[k];
        information_w += v[k] * v[k] * 0.5 * (kernel.spread + (cosine ? 0.5 : -0.5) * kernel.bend) -
                         cross * coupling[k];
    }

    const auto sd = [&](const Gradient& gradient) {
        double variance = 0;
        double through_w = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            variance += gradient[k] * gradient[k] / gram[k];
            through_w += gradient[k] * coupling[k];
        }
        return noise_sd * std::sqrt(variance + through_w * through_w / information_w);
    };

    constexpr Complex i{0, 1};
    const Polar plus = polar_gradient(phasors.c + i * phasors.d, 1, i);
    const Polar minus = polar_gradient(phasors.c - i * phasors.d, 1, -i);
    const Polar c = polar_gradient(phasors.c, 1, 0);
    const Polar d = polar_gradient(phasors.d, 0, 1);

    Precision precision;
    precision.sd.a_A = sd(combine(plus.modulus, 0.5, minus.modulus, 0.5));
    precision.sd.a_B = sd(combine(plus.modulus, 0.5, minus.modulus, -0.5));
    precision.sd.two_theta_A = sd(combine(plus.argument, 0.5, minus.argument, -0.5));
    precision.sd.alpha = sd(combine(plus.argument, -0.5, minus.argument, -0.5));
    precision.sd_delta_phi_CD = sd(combine(d.argument, 1, c.argument, -1));
    precision.sd_f_hz = noise_sd / std::sqrt(information_w) * rate_hz / (2 * std::numbers::pi);
    return precision;
}

}  // namespace vybeg
