#pragma once

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// Phasors between the centres of windows, from the means of 2 reach consecutive windows: the
// weights of least squares for which every frequency up to a quarter of a cycle per window (a beat
// of four windows and more) passes unchanged within 1e-6.
class BetweenWindows {
public:
    static constexpr std::size_t reach = 8;   // windows on each side
    static constexpr std::size_t parts = 16;  // of the way from a window to the next

    BetweenWindows();

    // The phasor `part` parts after the centre of the window before the last `reach` means.
    std::complex<double> at(std::size_t part, std::span<const std::complex<double>> means) const;

    // Phase from that centre to the next one, weighted by the power of both channels; summed over
    // steps so short that unequal modes are weighted by their power.
    double phase(std::span<const std::complex<double>> c,
                 std::span<const std::complex<double>> d) const;

    // Noise gain at a centre, in units of a window's noise variance.
    double noise_gain() const { return weights_.row(0).squaredNorm(); }

private:
    Eigen::MatrixXd weights_;  // a row for each part
};

}  // namespace vybeg
