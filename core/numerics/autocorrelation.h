#pragma once

#include "core/numerics/fft.h"

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace vybeg {

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
