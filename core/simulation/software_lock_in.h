#pragma once

#include "core/numerics/lock_in.h"

#include <array>
#include <complex>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// A lock-in of both channels of a simulated decay, in double precision: its stages filter
// 2 s(t) e^(-i w t) sample by sample.
class SoftwareLockIn {
public:
    // Rows of a log: every `samples_per_row` samples.
    SoftwareLockIn(const LockIn& filter, double f_ref_hz, double rate_hz,
                   std::int64_t samples_per_row);

    void take(std::span<const double> c, std::span<const double> d);

    // Rows t,Xc,Yc,Xd,Yd,F below a line of names, without those of the filter's settling; the times
    // are those at which the lock-in gave them.
    std::string table() const;

private:
    using Complex = std::complex<double>;

    LockIn filter_;
    double f_ref_hz_;
    double rate_hz_;
    std::int64_t samples_per_row_;
    double keep_;  // of a stage, from sample to sample
    std::int64_t frame_ = 0;
    std::array<std::vector<Complex>, 2> stages_;
    std::array<std::vector<Complex>, 2> rows_;
};

}  // namespace vybeg
