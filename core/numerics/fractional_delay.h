#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vybeg {

// Band-limited interpolation by a Kaiser-windowed sinc: x(t - delay) from the samples around t, for
// any delay in samples. Error below 1e-6 of the amplitude for sinusoids up to 0.4 of the sample
// rate (tested); a whole delay is exact.
class FractionalDelay {
public:
    // Precondition: |delay_samples| < 2^53.
    explicit FractionalDelay(double delay_samples);

    // Numbers of samples before and after a point that the interpolation uses, not negative: 0
    // where all of them lie on the other side.
    std::int64_t reach_before() const;
    std::int64_t reach_after() const;

    // out[i] = x(first + i - delay). Precondition: x covers [first - reach_before(), first +
    // out.size() + reach_after()). A sample of out has the same bits for any range of out; it is
    // NaN if one of the samples used is NaN.
    void apply(std::span<const double> x, std::int64_t first, std::span<double> out) const;

private:
    std::vector<double> taps_;
    std::int64_t offset_ = 0;  // of the first tap's sample from the point
};

}  // namespace vybeg
