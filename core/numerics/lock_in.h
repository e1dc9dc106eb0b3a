#pragma once

#include <complex>
#include <span>

namespace vybeg {

// The filter of a lock-in: RC stages of one time constant.
struct LockIn {
    int order = 0;            // stages; 0: no filter
    double bandwidth_hz = 0;  // 3 dB

    double tau_s() const;    // of a stage
    double delay_s() const;  // of what moves slowly

    // Response to a wave that is `offset_hz` above the reference, without the delay.
    std::complex<double> response(double offset_hz) const;

    // Correlation of white noise behind the filter, 1 at t = 0:
    //     integral of s^(p-1) (s + x)^(p-1) e^(-2s-x) ds over that of x = 0, x = |t| / tau.
    double correlation(double t_s) const;

    friend bool operator==(const LockIn&, const LockIn&) = default;
};

// Removes from the phasors of both channels, relative to f_ref_hz, what a filter of few stages
// leaves of the mixer's sum at twice the carrier: the image
//     h conj(z) exp(-2i 2 pi f_ref t)
// with one complex h of both channels, by least squares of the second differences, in which the
// motion is small. Rows that are too far apart for these, an image below the noise, and one that
// folds onto the motion itself stay as they are. `time_s`, `c`, `d`: of one length, in the order of
// time; all values finite.
void remove_image(double f_ref_hz, std::span<const double> time_s,
                  std::span<std::complex<double>> c, std::span<std::complex<double>> d);

}  // namespace vybeg
