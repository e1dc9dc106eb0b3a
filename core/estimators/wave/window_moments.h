#pragma once

#include "core/estimators/wave/wave_state.h"

#include <array>
#include <complex>
#include <cstdint>
#include <span>

namespace vybeg {

// Sums over the samples of a window at one trial frequency.
//
// Time inside a window is counted in samples from its centre: u_j = j - (n - 1)/2. The trial
// frequency w is in radians per sample, 0 < w < pi.

// One window of both channels; equal lengths.
struct Window {
    std::span<const double> c;
    std::span<const double> d;

    std::int64_t length() const { return static_cast<std::int64_t>(c.size()); }
};

// Sums of C^2, D^2, C D and, for algorithm 2, C(t) D(t - t3) over a window; not finite where a
// sample is missing.
template <class Real>
struct SampleProductsOf {
    Real cc{};
    Real dd{};
    Real cd{};
    Real cq{};
};
using SampleProducts = SampleProductsOf<double>;
SampleProducts sample_products(const Window& window);

// Sums over one channel: z[k] = sum_j u_j^k s_j e^{-i w u_j}. In the notation of (31), z[0] = n/2
// (C_x - i S_x).
using ChannelMoments = std::array<std::complex<double>, 3>;

struct WindowMoments {
    ChannelMoments c;
    ChannelMoments d;
};

// One pass over the samples. Relative error about 1e-15 for any length: the phase is anchored every
// 64 samples.
WindowMoments window_moments(const Window& window, double w);

// z[0] of both channels, for searches without derivatives.
Phasors window_projections(const Window& window, double w);

// Sums that depend on the window only, in closed form: deviation of cos and sin from orthogonal and
// equal.
template <class Real>
struct WindowKernelOf {
    Real gram_cos{};    // sum cos^2 w u = (n + D)/2, D = sin(n w)/sin w
    Real gram_sin{};    // sum sin^2 w u = (n - D)/2
    Real slope{};       // d gram_cos / dw = -sum u sin 2wu
    Real bend{};        // d^2 gram_cos / dw^2 = -2 sum u^2 cos 2wu
    double spread = 0;  // sum u^2 = n (n^2 - 1)/12
};
using WindowKernel = WindowKernelOf<double>;

WindowKernel window_kernel(std::int64_t n, double w);

// sum (C^2 + D^2) of the residual after taking Re(c e^{iwu}), Re(d e^{iwu}) from the samples: n F.
// Computed from residuals, not from moments, so that an almost perfect fit keeps its digits.
double residual_sum(const Window& window, const Phasors& phasors, double w);

}  // namespace vybeg
