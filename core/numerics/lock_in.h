#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace vybeg {

// The filter of a lock-in: RC stages of one time constant.
struct LockIn {
    int order = 0;            // stages; 0: no filter
    double bandwidth_hz = 0;  // 3 dB

    double tau_s() const;    // of a stage
    double delay_s() const;  // of what moves slowly

    // Response to a wave that is `offset_hz` above the reference, without the delay.
    std::complex<double> response(double offset_hz) const;

    // Takes the response, without the delay, out of phasors that turn slowly about `offset_hz`
    // above the reference: to first order in their turn, as the two modes of a wave are attenuated
    // unlike. `time_s`: of the rows, about `step_s` apart but for gaps.
    void take_out(double offset_hz, double step_s, std::span<const double> time_s,
                  std::vector<std::complex<double>>& z) const;

    // Correlation of white noise after the filter, 1 at t = 0:
    //     integral of s^(p-1) (s + x)^(p-1) e^(-2s-x) ds over that of x = 0, x = |t| / tau.
    double correlation(double t_s) const;

    // Correlation of the noise of means of `count` rows each, `step_s` apart, by their distance in
    // means, and the variance of one relative to that of a row.
    std::pair<std::vector<double>, double> noise_of_means(std::size_t count, double step_s) const;

    friend bool operator==(const LockIn&, const LockIn&) = default;
};

}  // namespace vybeg
