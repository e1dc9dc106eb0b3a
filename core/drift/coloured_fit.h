#pragma once

#include "core/base/job_control.h"

#include <Eigen/Core>

#include <vector>

namespace vybeg {

// A stretch of a series for a linear fit, with a row for each instant.
struct FitSegment {
    std::vector<double> time_s;  // rising
    Eigen::VectorXd count;       // samples of which each row is the mean
    // The regressors, and the measured value in the last column.
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows;
};

// Noise of a series: white noise of each sample, a walk, and a slow noise with the correlation
// exp(-rate |lag|), of the values themselves or of their rate. Of an angle the walk is the white
// noise of a rate.
struct SeriesNoise {
    enum class Slow { none, value, rate };

    double white = 0;  // variance of a sample, squared units
    double walk = 0;   // growth of the variance, squared units per s
    Slow slow = Slow::none;
    double slow_variance = 0;  // squared units, or squared units per s^2
    double slow_rate = 0;      // 1/s

    // Variance of the change of the measured value over a time.
    double variance_of_change(double seconds) const;
};

struct ColouredFit {
    Eigen::VectorXd coefficients;  // of the regressors; empty where the rows do not determine them
    Eigen::MatrixXd covariance;
    SeriesNoise noise;
};

// What the series is.
enum class SeriesKind {
    angle,  // the integral of a rate: it walks, and each segment has a start of its own
    value   // a signal about its mean
};

// Linear least squares under the residual's own noise: generalised least squares by a Kalman filter
// over all columns at once, which takes gaps and uneven times as they are; the noise is the most
// likely one with what the fit absorbs projected out (restricted maximum likelihood, H. D.
// Patterson and R. Thompson, 1971). A slow noise is taken where it raises the logarithm of the
// likelihood by four. Precondition: more rows than fitted numbers. A cancelled job ends the search
// for the noise early.
ColouredFit coloured_fit(const std::vector<FitSegment>& segments, SeriesKind kind,
                         const JobControl& job);

}  // namespace vybeg
