#pragma once

#include "core/numerics/fft.h"

#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace vybeg {

// One-sided power spectral densities of two real signals, squared units per Hz.
using Densities = std::array<std::vector<double>, 2>;

// Spectra of two real signals, averaged over segments under a Hann window (P. D. Welch, 1967).
// Their sum over all bins times the width of a bin is the mean of the squares under the window's
// square, which is the variance of a stationary signal without mean.
class SpectralDensity {
public:
    // Precondition: size is even and at least 4.
    SpectralDensity(std::size_t size, double rate_hz);

    std::size_t size() const { return fft_.size(); }
    // Bins from 0 to half the rate.
    std::size_t bins() const { return fft_.size() / 2 + 1; }
    double bin_hz() const { return rate_hz_ / static_cast<double>(fft_.size()); }

    // Adds the densities of one segment to `sums`. Precondition: x and y hold size() samples.
    void add_to(Densities& sums, std::span<const double> x, std::span<const double> y);

private:
    Fft fft_;
    double rate_hz_;
    double squares_ = 0;  // of the window
    std::vector<double> window_;
    std::vector<std::complex<double>> data_;
};

// Power of two complex signals together by frequency bin, unnormalised. Precondition: equal sizes.
std::vector<double> bin_powers(std::vector<std::complex<double>> c,
                               std::vector<std::complex<double>> d);

// Begins of the segments that cover a run of `length` samples, with an overlap of half a segment at
// most; none where the run is shorter than a segment.
std::vector<std::size_t> segments_of(std::size_t length, std::size_t segment);

// How far the mean of the densities of `segments` independent segments of white noise has to rise
// above their expectation to be exceeded with the given probability in one bin, as a ratio.
double ratio_exceeded(int segments, double probability);

// Sums of x[j] x[j + lag] of two real signals over runs of consecutive samples, for the lags 0 to
// `lags`, by FFT.
class LaggedProducts {
public:
    explicit LaggedProducts(std::size_t lags) : lags_(lags) {}

    // Adds a run; pairs across runs do not count. Precondition: equal lengths.
    void add(std::span<const double> x, std::span<const double> y);

    // r(lag) = mean of the products at this lag / mean of the squares: 1 at lag 0; shorter where no
    // pair lies so far apart. Empty where all samples are 0.
    std::array<std::vector<double>, 2> correlations() const;

private:
    std::size_t lags_;
    std::unique_ptr<const Fft> fft_;  // of the run before, mostly of the same size
    std::array<std::vector<double>, 2> sums_;
    std::vector<double> pairs_;
};

}  // namespace vybeg
