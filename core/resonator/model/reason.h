#pragma once

#include "core/base/message_arg.h"

#include <limits>
#include <string>
#include <vector>

namespace vybeg {

// Reasons for which a number of the resonator is not given.
enum class ReasonCode {
    none,           // it is given
    one_direction,  // args: another start angle (deg), seconds. The wave hardly moves.
    within_noise,   // args: greatest value, unit. The difference between the modes.
    // Args: another start angle (deg), seconds. Only determined together with the damping.
    confounded_rotation,
    free_model,          // the free model has modes, but no axes
    modes_not_apart,     // the modes' difference is within its noise
    no_decay,            // args: least tau (s)
    circular_wave,       // no angle where a_A = |a_B|
    few_angles,          // no drift function: too few angles of the waves
    kappa_like_damping,  // gain ratio and damping anisotropy are indistinguishable
    as_given,            // the recordings narrow the tolerance of the channels by less than ten
    held,                // a channel error without a tolerance: taken as zero
    not_nonlinear,       // args: limit, unit. The phasors need no dependence on the amplitude.
    drift_not_seen,      // a drift is indistinguishable from the motion in this recording
    decay_limits,        // args: least and greatest tau (s)
    grows,               // args: rate of growth, its sd (1/s)
    mode_grows,          // args: the mode (Hz), rate of growth, its sd (1/s). The model is wrong.
    same_projection,     // both channels show the same projection of the motion
    amplitude_or_time,   // a settling frequency explains the phasors as well
    rests_on_unseen,     // more than half of its variance is due to undetermined parameters
    too_few_windows,     // not enough windows for it in this run
    set_refused,         // the recordings are not of one resonator
    left_out,            // this recording does not belong to the set
    frequencies_apart,   // args: ppm. Those of the recordings.
    not_converged,       // the fit stopped early
    phase_lost,          // E, R, S, Q have no frequency
    logs_differ,         // whole-angle logs differ in it, or in what it is found from
    effort_missing,      // of a whole-angle log: no column of it
    effort_negative,     // its mean takes energy from the wave
    effort_unseen,       // its fourth harmonic, or that of the drift, is within its noise
    effort_axis_apart,   // args: degrees between the damping axes of effort and drift
};

struct Reason {
    ReasonCode code = ReasonCode::none;
    std::vector<MessageArg> args;

    friend bool operator==(const Reason&, const Reason&) = default;
};

// A number with its standard deviation, or the reason for its absence with NaN for both.
struct Estimate {
    double value = std::numeric_limits<double>::quiet_NaN();
    double sd = std::numeric_limits<double>::quiet_NaN();  // statistical
    Reason reason;
    // Combined standard uncertainty: sd and the contribution of the tolerances, told or assumed.
    // NaN without tolerances.
    double u = std::numeric_limits<double>::quiet_NaN();

    bool given() const { return reason.code == ReasonCode::none; }
    double uncertainty() const { return u >= sd ? u : sd; }
};

// Name of a reason in JSON, e.g. "one-direction".
std::string reason_name(ReasonCode code);

// With its English sentence, %1, %2, ... are the arguments (context "Reason"), and no grade.
MessageRow message_row(ReasonCode code);

// The whole English sentence.
std::string english(const Reason& reason);

}  // namespace vybeg
