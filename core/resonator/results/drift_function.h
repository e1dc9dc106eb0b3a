#pragma once

#include "core/base/job_control.h"
#include "core/resonator/model/phasor_run.h"
#include "core/resonator/results/resonator_result.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// The drift function: d theta_A/dt of a linear wave against theta_A (rad/s, rad). Angles that
// differ by pi/2 are the same motion, so its harmonics are those of 4 theta, 8 theta, ...
//
//     d theta_A/dt = m + c4 cos 4 theta + s4 sin 4 theta + c8 cos 8 theta + s8 sin 8 theta
//
// By METHOD section 8, m = -k Omega = -r/2 and the fourth harmonic is (g/4) sin 4(theta -
// theta_tau): these follow from the resonator's fit, with its covariance. The eighth, which no
// linear resonator has, follows from the residual angles of the fit.

// Mean drift over a segment of one run, along which the angle moves by at most 5 degrees: drift of
// a linear wave at this angle by the fitted resonator, plus the slope of the measured angle less
// the fitted motion. The effect of the quadrature is in the motion, not in the point.
struct DriftPoint {
    std::size_t run = 0;
    double theta = 0;  // in (-pi/4, pi/4]
    double rate = 0;   // rad/s
    double sd_rate = 0;
};

struct DriftFunction {
    std::vector<DriftPoint> points;  // none for order 0
    // Highest harmonic determined by the set: 0 (none, unknown curve), 4, 8.
    int order = 0;
    // m, c4, s4, c8, s8 up to `order`, rad/s; empty for order 0.
    Eigen::VectorXd coefficients;
    Eigen::MatrixXd covariance;   // statistical
    Eigen::MatrixXd tolerances;   // contribution of the channels' tolerances: zero without any
    double chi2_per_freedom = 0;  // of the measured angles about the fitted ones

    // A coefficient with sd and u. Precondition: k < coefficients.size().
    Estimate coefficient(Eigen::Index k) const;

    // Curve, its standard deviation and its u (that deviation without tolerances) at an angle.
    // Precondition: order > 0.
    double rate(double theta) const;
    double sd_rate(double theta) const;
    double u_rate(double theta) const;
};

// `fit`: the structured fit of the runs. The eighth harmonic is present if the angles separate all
// five terms; its regressors are integrals along the fitted motion, never along the noisy track.
// Windows whose smaller travelling wave lies within six standard deviations of zero have no angle.
// A cancelled job ends it early.
DriftFunction drift_function(std::span<const PhasorRun> runs, const ResonatorFit& fit,
                             const JobControl& job = {});

// The same curve from the slow dynamics dz/dt = M z (METHOD section 8), for a linear wave.
double drift_of_dynamics(const Eigen::Matrix2cd& m, double theta);

}  // namespace vybeg
