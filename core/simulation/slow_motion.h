#pragma once

#include "core/simulation/free_decay.h"

#include <Eigen/Core>

#include <cmath>
#include <complex>

namespace vybeg {

// Fractional turns of a frequency up to a frame (whole or half), exact to rounding for any length:
// the product is reduced by whole turns, which is exact, with its own rounding error carried.
inline double turns_at(double frame, double f_hz, double rate_hz) {
    const double product = frame * f_hz;
    const double lost = std::fma(frame, f_hz, -product);
    return (std::remainder(product, rate_hz) + lost) / rate_hz;
}

// The slow motion dz/dt = M z of METHOD section 8, z = (c, d) relative to f0, in closed form. M is
// split into its mean m and a traceless N with N^2 = s^2 I, so that
//     exp(M t) = exp(m t) (cosh(s t) I + sinh(s t)/s N)
// for every t at once: no step, no accumulated error.
class SlowMotion {
public:
    // Precondition: check(decay) passes.
    explicit SlowMotion(const FreeDecay& decay);

    // exp(M t), t in seconds.
    Eigen::Matrix2cd propagator(double t) const;

    // e^{i w0 t} at a frame (whole or half), exact to rounding however long the record.
    std::complex<double> carrier(double frame) const;

    // The phasors with their carrier, z e^{i w0 t}, at a frame: the signals are their real parts.
    Eigen::Vector2cd at_frame(double frame) const {
        return propagator(frame / rate_hz_) * start_ * carrier(frame);
    }

    // Mean rate of phase of z, weighted with the power of its components, relative to f0:
    // Im(z^H M z) / (2 pi |z|^2), Hz. NaN where z = 0.
    double frequency_offset_hz(const Eigen::Vector2cd& z) const;

    // M, 1/s, and z at t = 0.
    Eigen::Matrix2cd matrix() const { return mean_ * Eigen::Matrix2cd::Identity() + traceless_; }
    const Eigen::Vector2cd& start() const { return start_; }

private:
    double f0_hz_;
    double rate_hz_;
    std::complex<double> mean_;        // m, 1/s
    Eigen::Matrix2cd traceless_;       // N, 1/s
    std::complex<double> half_split_;  // s, 1/s
    Eigen::Vector2cd start_;
};

}  // namespace vybeg
