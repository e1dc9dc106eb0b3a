#pragma once

#include "core/estimators/wave_state.h"
#include "core/estimators/window_moments.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace vybeg {

// Means of a window's phasors at a fixed frequency, with slow variation up to the second order
// taken out (phasor_windows.h). Everything that is the same for all windows is made once.
class WindowMean {
public:
    // Windows of n samples, carrier w (rad per sample). Precondition: n >= 16 and n w >= 4 pi.
    WindowMean(std::int64_t n, double w);

    struct Estimate {
        Phasors mean;            // relative to the window's centre
        double noise_power = 0;  // variance per sample, from the residual; NaN: samples are missing
    };
    Estimate estimate(const Window& window) const;

    // Standard deviation of a real or imaginary part of a mean, in units of the noise's.
    double sd_of_part() const { return sd_of_part_; }
    // Degrees of freedom of noise_power.
    double freedom() const { return 2 * static_cast<double>(n_) - 12; }

private:
    // One channel: its mean, and the power that the six functions take out of its samples.
    struct Channel {
        std::complex<double> mean;
        double power = 0;
    };
    Channel channel(const ChannelMoments& moments) const;

    std::int64_t n_;
    double w_;
    double mean_square_;  // of u
    // Inverse normal matrices of the functions that are even in u, {cos, P_1 sin, P_2 cos}, and of
    // the odd ones, {sin, P_1 cos, P_2 sin}.
    Eigen::Matrix3d even_;
    Eigen::Matrix3d odd_;
    double sd_of_part_;
};

}  // namespace vybeg
