#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vybeg {

// Band-limited interpolation by a Kaiser-windowed sinc: x(t - delay) from the samples around t, for
// any delay in samples. Error below 1e-6 of the amplitude for sinusoids up to 0.4 of the sample
// rate (tested).
class FractionalDelay {
public:
    explicit FractionalDelay(double delay_samples);

    // Samples before and after a point that the interpolation reaches.
    std::int64_t reach_before() const { return reach_before_; }
    std::int64_t reach_after() const { return reach_after_; }

    // out[i] = x(first + i - delay). Precondition: x covers [first - reach_before(),
    // first + out.size() + reach_after()).
    void apply(std::span<const double> x, std::int64_t first, std::span<double> out) const;

private:
    std::vector<double> taps_;
    std::int64_t reach_before_ = 0;
    std::int64_t reach_after_ = 0;
};

}  // namespace vybeg
