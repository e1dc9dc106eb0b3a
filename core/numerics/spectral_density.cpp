#include "core/numerics/spectral_density.h"

#include <cmath>
#include <numbers>

namespace vybeg {

SpectralDensity::SpectralDensity(std::size_t size, double rate_hz)
    : fft_(size), rate_hz_(rate_hz), window_(size), data_(size) {
    const double turn = 2 * std::numbers::pi / static_cast<double>(size);
    for (std::size_t j = 0; j < size; ++j) {
        window_[j] = 0.5 - 0.5 * std::cos(turn * static_cast<double>(j));
        squares_ += window_[j] * window_[j];
    }
}

void SpectralDensity::add_to(Densities& sums, std::span<const double> x,
                             std::span<const double> y) {
    const std::size_t size = fft_.size();
    for (std::vector<double>& sum : sums) {
        sum.resize(bins());
    }
    for (std::size_t j = 0; j < size; ++j) {
        data_[j] = window_[j] * std::complex<double>(x[j], y[j]);
    }
    fft_.forward(data_);
    for (std::size_t k = 0; k < bins(); ++k) {
        // The spectra of x and y are the even and the odd part of that of x + iy.
        const std::complex<double> here = data_[k];
        const std::complex<double> mirrored = std::conj(data_[k == 0 ? 0 : size - k]);
        const double sides = k == 0 || 2 * k == size ? 1 : 2;
        const double scale = 0.25 * sides / (squares_ * rate_hz_);
        sums[0][k] += scale * std::norm(here + mirrored);
        sums[1][k] += scale * std::norm(here - mirrored);
    }
}

std::vector<std::size_t> segments_of(std::size_t length, std::size_t segment) {
    std::vector<std::size_t> begins;
    if (length < segment) {
        return begins;
    }
    const std::size_t spare = length - segment;
    const std::size_t count = 2 * spare / segment + 1;
    for (std::size_t k = 0; k < count; ++k) {
        begins.push_back(count == 1 ? 0 : spare * k / (count - 1));
    }
    return begins;
}

double ratio_exceeded(int segments, double probability) {
    // The sum of n exponential distributions exceeds x with the probability
    // e^-x (1 + x + x^2/2! + ... + x^(n-1)/(n-1)!).
    const auto exceeds = [segments](double x) {
        double term = std::exp(-x);
        double sum = term;
        for (int j = 1; j < segments; ++j) {
            term *= x / j;
            sum += term;
        }
        return sum;
    };
    double low = segments;
    double high = segments - std::log(probability) + 8 * std::sqrt(segments) + 8;
    while (exceeds(high) > probability) {
        high *= 2;
    }
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (exceeds(middle) > probability ? low : high) = middle;
    }
    return high / segments;
}

}  // namespace vybeg
