#pragma once

#include <limits>
#include <string>
#include <vector>

namespace vybeg {

// Why a number of the resonator is not given.
enum class ReasonCode {
    none,                  // it is given
    one_direction,         // args: another start angle (deg), seconds. The wave hardly moves.
    below_noise,           // args: the value, its sd. No axis without a difference between modes.
    confounded_rotation,   // args: another start angle (deg), seconds. Seen only with the damping.
    free_model,            // the free model knows modes, no axes
    modes_not_apart,       // the modes' difference is within its noise
    no_decay,              // args: 1/tau, its sd (1/s)
    circular_wave,         // no angle where a_A = |a_B|
    few_angles,            // no drift function: the waves stand at too few angles
    kappa_still_wave,      // args: angle turned (deg), angle needed (deg)
    kappa_like_damping,    // gain ratio and damping anisotropy look the same
    kappa_not_seen,        // this motion does not show the gain ratio
    channels_one_number,   // M tells one number of the channels, taken as their gain ratio
    not_asked,             // the caller asked for no estimate of it
    amplitude_like_drift,  // within this decay the amplitude does not tell it from a drift
    residual_from_elsewhere,  // significant, but it leaves most of the residual
    too_few_windows,          // not enough windows for it in this run
};

struct Reason {
    ReasonCode code = ReasonCode::none;
    std::vector<std::string> args;

    friend bool operator==(const Reason&, const Reason&) = default;
};

// A number with its standard deviation, or the reason why there is none; then both are NaN.
struct Estimate {
    double value = std::numeric_limits<double>::quiet_NaN();
    double sd = std::numeric_limits<double>::quiet_NaN();
    Reason reason;

    bool given() const { return reason.code == ReasonCode::none; }
};

// The name of a reason as it stands in JSON, e.g. "one-direction".
std::string reason_name(ReasonCode code);

// English sentence template, %1, %2, ... are the arguments; translated like those of messages.h.
const char* message_template(ReasonCode code);

// The whole English sentence.
std::string english(const Reason& reason);

}  // namespace vybeg
