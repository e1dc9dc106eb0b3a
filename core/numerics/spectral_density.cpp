#include "core/numerics/spectral_density.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

// Four times the powers of x and y in a bin: their spectra are the even and the odd part of that of
// x + iy.
std::pair<double, double> four_powers(std::span<const std::complex<double>> spectrum,
                                      std::size_t k) {
    const std::complex<double> mirrored = std::conj(spectrum[k == 0 ? 0 : spectrum.size() - k]);
    return {std::norm(spectrum[k] + mirrored), std::norm(spectrum[k] - mirrored)};
}

}  // namespace

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
        const double sides = k == 0 || 2 * k == size ? 1 : 2;
        const double scale = 0.25 * sides / (squares_ * rate_hz_);
        const auto [of_x, of_y] = four_powers(data_, k);
        sums[0][k] += scale * of_x;
        sums[1][k] += scale * of_y;
    }
}

std::vector<double> bin_powers(std::vector<std::complex<double>> c,
                               std::vector<std::complex<double>> d) {
    const Fft transform(c.size());
    transform.forward(c);
    transform.forward(d);
    std::vector<double> power(c.size());
    for (std::size_t bin = 0; bin < power.size(); ++bin) {
        power[bin] = std::norm(c[bin]) + std::norm(d[bin]);
    }
    return power;
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
    double high = segments - std::log(probability) + 8 * std::sqrt(segments) + 8;
    while (exceeds(high) > probability) {
        high *= 2;
    }
    const auto too_likely = [&](double x) { return exceeds(x) > probability; };
    return bisected(segments, high, too_likely) / segments;
}

void LaggedProducts::add(std::span<const double> x, std::span<const double> y) {
    const std::size_t count = x.size();
    if (count == 0) {
        return;
    }
    const std::size_t lags = std::min(lags_, count - 1);
    pairs_.resize(lags_ + 1);
    for (std::vector<double>& sum : sums_) {
        sum.resize(lags_ + 1);
    }
    // The zeros after the samples keep the products of both ends apart.
    const std::size_t size = std::bit_ceil(count + lags);
    std::vector<std::complex<double>> data(size);
    for (std::size_t j = 0; j < count; ++j) {
        data[j] = {x[j], y[j]};
    }
    if (!fft_ || fft_->size() != size) {
        fft_ = std::make_unique<const Fft>(size);
    }
    fft_->forward(data);
    std::vector<std::complex<double>> powers(size);
    for (std::size_t k = 0; k < size; ++k) {
        // Both powers are even, so that their transforms are real and share one complex transform.
        const auto [of_x, of_y] = four_powers(data, k);
        powers[k] = {0.25 * of_x, 0.25 * of_y};
    }
    fft_->inverse(powers);
    for (std::size_t lag = 0; lag <= lags; ++lag) {
        sums_[0][lag] += powers[lag].real() / static_cast<double>(size);
        sums_[1][lag] += powers[lag].imag() / static_cast<double>(size);
        pairs_[lag] += static_cast<double>(count - lag);
    }
}

std::array<std::vector<double>, 2> LaggedProducts::correlations() const {
    std::array<std::vector<double>, 2> found;
    for (std::size_t channel = 0; channel < found.size(); ++channel) {
        const std::vector<double>& sums = sums_[channel];
        if (sums.empty() || !(sums[0] > 0)) {
            continue;
        }
        for (std::size_t lag = 0; lag < sums.size() && pairs_[lag] > 0; ++lag) {
            found[channel].push_back(sums[lag] / pairs_[lag] * pairs_[0] / sums[0]);
        }
    }
    return found;
}

}  // namespace vybeg
