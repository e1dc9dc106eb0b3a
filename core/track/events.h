#pragma once

#include "core/track/track.h"

#include <vector>

namespace vybeg {

enum class EventKind {
    axis_crossing,
    gap,
    clipped,
    not_converged,
    filter_transient,
    delay_reach,
    moving
};

// Event of a track. An axis crossing is the instant at which 2theta_A passes a multiple of pi/2
// (METHOD section 7); the others are consecutive windows with that flag, from time_s on, for
// `seconds`.
struct Event {
    EventKind kind{};
    double time_s = 0;
    double seconds = 0;           // 0 for an instant
    int multiple_of_half_pi = 0;  // axis crossings: which axis
    int direction = 0;            // axis crossings: +1 rising 2theta_A, -1 falling

    friend bool operator==(const Event&, const Event&) = default;
};

// All events of a track in the order of time. Crossings within the noise of the angle count once:
// the angle must leave the axis by more than six standard deviations on both sides. Windows with
// Flag::moving have one only where the motion inside is small and the phase confirms the branch of
// their angle, uncertain otherwise.
std::vector<Event> find_events(const Track& track);

}  // namespace vybeg
