#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/drift/coloured_fit.h"
#include "core/drift/whole_angle_log.h"
#include "core/resonator/model/reason.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// The drift of a wave whose amplitude is held, against its angle:
//
//     d theta_A/dt = m + c2 cos 2 theta + s2 sin 2 theta + c4 cos 4 theta + s4 sin 4 theta
//
// m is the turn of the log (input rate and bias), the fourth harmonic the damping anisotropy,
// (g/4) sin 4(theta - theta_tau); a second one belongs to electrodes and electronics. The harmonics
// are those of all logs, each of which has a turn of its own.
inline constexpr std::array log_harmonics{2, 4};
inline constexpr Eigen::Index log_terms = 5;  // m, c2, s2, c4, s4
inline constexpr Eigen::Index fourth = 3;     // where the fourth harmonic begins
inline constexpr std::array<const char*, log_terms> log_term_names{"mean", "cos2", "sin2", "cos4",
                                                                   "sin4"};
// From this normal deviate on two numbers are not the same.
inline constexpr double log_differs = 3.2;

// Mean rate less the turn of its log in a range of angles, of a log or over all.
struct LogBin {
    double theta = 0;  // centre, in [0, pi), rad
    double rate = 0;   // rad/s; NaN where no wave was
    double sd = 0;
    double seconds = 0;
};

// One log by itself: the fit of its angle, with the coefficients m, c2, s2, c4, s4 in rad/s.
struct LogDrift : ColouredFit {
    std::string name;
    std::string sha256;  // as of the log
    double seconds = 0;
    double turn = 0;                        // rad
    double period = 0;                      // of its angle, as UnwrappedAngle::period
    std::vector<Diagnostic> warnings = {};  // likewise
    std::size_t rows = 0;                   // with an angle
    std::size_t missing = 0;                // rows without
    // The efforts of the controller against the angle: mean, c2, s2, c4, s4 in their unit.
    std::optional<ColouredFit> amplitude;
    std::optional<ColouredFit> quadrature;
    std::vector<LogBin> bins;

    Estimate coefficient(Eigen::Index term) const {
        return {coefficients[term], std::sqrt(covariance(term, term)), {}};
    }
};

// Errors: turn_too_short, turn_too_fast, angle_unit_wrong, too_few_frames, no_valid_samples.
Result<LogDrift> log_drift(const WholeAngleLog& log, const JobControl& job);

}  // namespace vybeg
