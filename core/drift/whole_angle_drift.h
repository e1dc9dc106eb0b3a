#pragma once

#include "core/base/diagnostic.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/drift/held_resonator.h"
#include "core/drift/log_drift.h"
#include "core/drift/whole_angle_log.h"
#include "core/resonator/model/channel_tolerance.h"
#include "core/resonator/model/reason.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// Whether the logs have the same harmonic: chi^2 of their values about the weighted mean, as a
// normal deviate.
struct LogAgreement {
    int harmonic = 0;  // 0: the turn, which may well differ; 2, 4
    double chi2 = 0;
    double freedom = 0;  // 0: there is one log
    double deviations = 0;
    bool agrees = true;
};

struct WholeAngleDrift {
    std::vector<LogDrift> logs;
    // m, c2, s2, c4, s4 of all logs, rad/s. A number in which the logs differ has a reason.
    std::array<Estimate, log_terms> harmonics;
    Eigen::MatrixXd covariance;           // NaN of those that differ
    std::vector<LogAgreement> agreement;  // of 0, 2, 4
    std::optional<std::size_t> left_out;  // the log that does not belong to the others
    std::vector<LogBin> bins;  // without the part that logs of unlike turns assign to the channels
    HeldResonator resonator;
    std::vector<Diagnostic> warnings;

    // The curve less the turn, and its standard deviation, rad/s.
    double rate(double theta) const;
    double sd_rate(double theta) const;
};

// Gain ratio and skew of channels without stated tolerances.
ChannelTolerance usual_pick_offs();

// Fits each log and puts the logs together. Standard deviations follow the noise of the residual,
// white or not (coloured_fit.h). Gain ratio and skew of the channels within their tolerance make a
// turning wave look as if it drifted in the fourth harmonic: logs of unlike turns separate both,
// otherwise u holds it. Errors, about the log: turn_too_short, turn_too_fast,
// angle_unit_wrong, too_few_frames, no_valid_samples, same_recording; interrupted.
// Precondition: one log or more.
Result<WholeAngleDrift> whole_angle_drift(std::span<const WholeAngleLog> logs,
                                          const JobControl& job,
                                          const ChannelTolerance& channels = usual_pick_offs());

}  // namespace vybeg
