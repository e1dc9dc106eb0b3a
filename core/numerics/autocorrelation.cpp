#include "core/numerics/autocorrelation.h"

#include <algorithm>
#include <bit>
#include <complex>

namespace vybeg {

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
    // The zeros behind the samples keep the products of both ends apart.
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
        // The spectra of x and y are the even and the odd part of that of x + iy. Both powers are
        // even, so that their transforms are real and share one complex transform.
        const std::complex<double> mirrored = std::conj(data[k == 0 ? 0 : size - k]);
        powers[k] = {0.25 * std::norm(data[k] + mirrored), 0.25 * std::norm(data[k] - mirrored)};
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
