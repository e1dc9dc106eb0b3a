#pragma once

#include "core/track/track.h"

#include <optional>
#include <vector>

namespace vybeg {

// Event of a track: consecutive windows with `flag`, from time_s on, for `seconds`; without a flag
// an axis crossing, the instant at which 2theta_A passes a multiple of pi/2 (METHOD section 7).
struct Event {
    std::optional<Flag> flag;
    double time_s = 0;
    double seconds = 0;           // 0 for an instant
    int multiple_of_half_pi = 0;  // axis crossings: which axis
    int direction = 0;            // axis crossings: +1 rising 2theta_A, -1 falling

    friend bool operator==(const Event&, const Event&) = default;
};

// The axis crossings of a track and its windows with missing or clipped samples, transients, delays
// beyond the samples, motion or no convergence, in the order of time. Crossings within the noise of
// the angle count once: the angle must leave the axis by more than six standard deviations on both
// sides. Windows with Flag::moving have one only where the motion inside is small and the phase
// confirms the branch of their angle, uncertain otherwise.
std::vector<Event> find_events(const Track& track);

}  // namespace vybeg
