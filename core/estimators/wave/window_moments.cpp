#include "core/estimators/wave/window_moments.h"

#include <algorithm>
#include <cmath>

namespace vybeg {
namespace {

using Complex = std::complex<double>;

// The rotation e^{-iwu} is updated from sample to sample within a block and recomputed at the start
// of each block, which limits its error to block_length roundings.
constexpr std::int64_t block_length = 64;

// Complex product without the checks for infinity that operator* makes.
inline Complex times(Complex a, Complex b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

inline Complex unit(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

// Calls block(first, last, u_first, e^{-i w u_first}) for consecutive blocks of the window.
template <class Block>
void for_blocks(std::int64_t n, double w, Block block) {
    const double centre = 0.5 * static_cast<double>(n - 1);
    for (std::int64_t first = 0; first < n; first += block_length) {
        const double u = static_cast<double>(first) - centre;
        block(first, std::min(first + block_length, n), u, unit(-w * u));
    }
}

}  // namespace

SampleProducts sample_products(const Window& window) {
    SampleProducts sum;
    for (std::size_t j = 0; j < window.c.size(); ++j) {
        sum.cc += window.c[j] * window.c[j];
        sum.dd += window.d[j] * window.d[j];
        sum.cd += window.c[j] * window.d[j];
    }
    return sum;
}

WindowMoments window_moments(const Window& window, double w) {
    WindowMoments sum{};
    const Complex step = unit(-w);
    for_blocks(window.length(), w, [&](std::int64_t first, std::int64_t last, double u, Complex r) {
        // Powers of the position in the block: small numbers, shifted to the window's centre below.
        WindowMoments block{};
        double v = 0;
        for (std::int64_t j = first; j < last; ++j, v += 1) {
            const auto at = static_cast<std::size_t>(j);
            const Complex c = window.c[at] * r;
            const Complex d = window.d[at] * r;
            block.c[0] += c;
            block.c[1] += v * c;
            block.c[2] += v * v * c;
            block.d[0] += d;
            block.d[1] += v * d;
            block.d[2] += v * v * d;
            r = times(r, step);
        }
        const auto shift = [u](ChannelMoments& total, const ChannelMoments& part) {
            total[0] += part[0];
            total[1] += part[1] + u * part[0];
            total[2] += part[2] + 2 * u * part[1] + u * u * part[0];
        };
        shift(sum.c, block.c);
        shift(sum.d, block.d);
    });
    return sum;
}

Phasors window_projections(const Window& window, double w) {
    Phasors sum{};
    const Complex step = unit(-w);
    for_blocks(window.length(), w, [&](std::int64_t first, std::int64_t last, double, Complex r) {
        for (std::int64_t j = first; j < last; ++j) {
            const auto at = static_cast<std::size_t>(j);
            sum.c += window.c[at] * r;
            sum.d += window.d[at] * r;
            r = times(r, step);
        }
    });
    return sum;
}

WindowKernel window_kernel(std::int64_t n, double w) {
    const auto count = static_cast<double>(n);
    const double sine = std::sin(w);
    const double cosine = std::cos(w);
    // D sin w = sin n w, differentiated twice.
    const double d0 = std::sin(count * w) / sine;
    const double d1 = (count * std::cos(count * w) - d0 * cosine) / sine;
    const double d2 = (1 - count * count) * d0 - 2 * d1 * cosine / sine;
    return {0.5 * (count + d0), 0.5 * (count - d0), 0.5 * d1, 0.5 * d2,
            count * (count * count - 1) / 12};
}

double residual_sum(const Window& window, const Phasors& phasors, double w) {
    double sum = 0;
    const Complex step = unit(w);
    for_blocks(window.length(), w, [&](std::int64_t first, std::int64_t last, double, Complex r) {
        Complex wave = std::conj(r);
        for (std::int64_t j = first; j < last; ++j) {
            const auto at = static_cast<std::size_t>(j);
            const double c = window.c[at] - times(phasors.c, wave).real();
            const double d = window.d[at] - times(phasors.d, wave).real();
            sum += c * c + d * d;
            wave = times(wave, step);
        }
    });
    return sum;
}

}  // namespace vybeg
