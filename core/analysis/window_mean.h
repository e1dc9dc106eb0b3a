#pragma once

#include "core/estimators/wave/wave_state.h"
#include "core/estimators/wave/window_moments.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace vybeg {

// Means of a window's phasors at a fixed frequency. Each channel is fitted by least squares with
//     sum over k of P_k(u) (A_k cos wu + B_k sin wu) + offset + slope u + lines of the mains,
// P_k the polynomials orthogonal over the window: A_0 - i B_0 is the phasor's mean. Slow variation
// of the wave, an offset and hum then neither bias the mean nor count as noise. The order of the
// polynomials grows with the window, from 2 (two periods) to 5 (ten periods and more): at a turn
// of 0.1 revolution in the window order 5 leaves 3e-6 of the amplitude. Everything that is the same
// for all windows is made once.
class WindowMean {
public:
    // Windows of n samples, carrier w (rad per sample), lines of the mains (rad per sample; they
    // lie 4 pi / n or more from w). Precondition: n >= 16 and n w >= 4 pi.
    WindowMean(std::int64_t n, double w, std::span<const double> lines = {});

    struct Estimate {
        Phasors mean;            // relative to the window's centre
        double noise_power = 0;  // variance per sample, from the residual; NaN: samples are missing
    };
    Estimate estimate(const Window& window) const;

    // Standard deviation of a real or imaginary part of a mean, in units of the noise's.
    double sd_of_part() const { return sd_of_part_; }
    // Degrees of freedom of noise_power.
    double freedom() const { return freedom_; }

private:
    // One channel: its mean, and the power that the functions take out of its samples.
    struct Channel {
        std::complex<double> mean;
        double power = 0;
    };
    Channel channel(std::span<const double> samples) const;

    Eigen::MatrixXd basis_;     // orthonormal columns
    Eigen::Matrix2Xd mean_of_;  // (A_0, -B_0) from the products with these columns
    double freedom_ = 0;
    double sd_of_part_ = 0;
};

}  // namespace vybeg
