#pragma once

#include "core/resonator/phasor_run.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// The drift function: d theta_A/dt of a linear wave against theta_A (rad/s, rad). Angles that
// differ by pi/2 are the same motion, so that its harmonics are those of 4 theta, 8 theta, ...
//
//     d theta_A/dt = m + p (c4 cos 4 theta + s4 sin 4 theta) + c8 cos 8 theta + s8 sin 8 theta
//                      + q (c cos 4 theta + s sin 4 theta),
//     p = (a_A^2 + a_B^2)/(a_A^2 - a_B^2), q = a_A a_B/(a_A^2 - a_B^2).
//
// By METHOD section 8, m = -k Omega and the fourth harmonic is (g/4) sin 4(theta - theta_tau). The
// last line is what the split does through the quadrature, -pi split cos 4(theta - theta_w); it is
// fitted along where there is a quadrature, and is no part of the curve.

// The mean drift over a stretch of one run, along which the angle moves by 5 degrees at most; less
// what the quadrature does, where the curve is known.
struct DriftPoint {
    std::size_t run = 0;
    double theta = 0;  // in (-pi/4, pi/4]
    double rate = 0;   // rad/s
    double sd_rate = 0;
};

struct DriftFunction {
    std::vector<DriftPoint> points;
    // Highest harmonic that the angles of the set can tell: 0 (none: the curve is not known), 4, 8.
    int order = 0;
    // m, c4, s4, c8, s8 as far as `order` goes, rad/s; empty where it is 0.
    Eigen::VectorXd coefficients;
    Eigen::MatrixXd covariance;
    double chi2_per_freedom = 0;  // above 1 significantly, it is in the covariance

    // The curve, where it is known.
    double rate(double theta) const;
    double sd_rate(double theta) const;
};

// Fitted by least squares to theta_A(t) itself, with the integrals of the right-hand side along the
// measured track, weights of METHOD section 6, and a start angle for each stretch without a gap: no
// track is differentiated. Windows whose smaller travelling wave lies within six standard
// deviations of zero have no angle and do not count. A set that stands at fewer than three angles,
// or at angles too near to each other, leaves `order` 0.
DriftFunction drift_function(std::span<const PhasorRun> runs);

// The same curve as the slow dynamics dz/dt = M z have it (METHOD section 8), for a linear wave.
double drift_of_dynamics(const Eigen::Matrix2cd& m, double theta);

}  // namespace vybeg
