#pragma once

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// Samples of both channels, none missing.
struct TwoChannels {
    std::span<const double> c;
    std::span<const double> d;
};

// Lines of a short segment as slowly varying waves, one least-squares fit for both channels:
//     x[j] = sum over lines of Re(P_i(u) e^{i w_i j}) + P_0(u),  u = (j - middle) / (length / 2),
// P polynomials of the order that the length allows, 1 from 48 samples on, 2 from 192. j counts
// from the start of the segment.
class LocalLines {
public:
    // Precondition: segment.c.size() >= least_samples(w.size()).
    LocalLines(const TwoChannels& segment, std::vector<double> w);

    static std::size_t least_samples(std::size_t lines);

    // P_i(u) e^{i w_i j} of the channels c and d, at any j, whole or not.
    Eigen::Vector2cd phasor(std::size_t line, double j) const;
    // Variance of the real part of a channel's phasor; the imaginary one has the same.
    double variance(std::size_t line, double j) const;
    // Noise variance of a sample, mean of both channels.
    double noise_variance() const { return noise_variance_; }
    // Mean of |P_i|^2 over the segment, both channels summed.
    double power(std::size_t line) const;
    // Sum of all lines and the offset at j.
    Eigen::Vector2d sample(double j) const;
    // Residual of the fit, samples x channels.
    const Eigen::MatrixX2d& residual() const { return residual_; }

private:
    double u(double j) const { return 2 * j / length_ - 1; }
    Eigen::Index column(std::size_t line) const;

    std::vector<double> w_;
    double length_;
    Eigen::Index order_;
    double noise_variance_ = 0;      // of a sample, the mean of both channels
    Eigen::MatrixX2d coefficients_;  // offset's powers of u, then lines' cos and sin of each power
    Eigen::MatrixXd inverse_;        // of the normal matrix
    Eigen::MatrixX2d residual_;
};

// The frequencies (rad per sample, ascending in no order, strongest first) of the strong lines of
// two segments of about the same length: above the noise and a hundredth of the amplitude of the
// strongest one, at most eight. Lines closer than 1.5 bins of the shorter segment count as one with
// varying amplitude.
std::vector<double> strong_lines(const TwoChannels& before, const TwoChannels& after);

}  // namespace vybeg
