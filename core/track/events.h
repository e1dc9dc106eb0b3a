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

// Something that happened in a track. An axis crossing is the instant at which 2theta_A passes a
// multiple of pi/2 (METHOD section 7); the others are stretches of windows with that flag, which
// begin at time_s and last seconds.
struct Event {
    EventKind kind{};
    double time_s = 0;
    double seconds = 0;           // 0 for an instant
    int multiple_of_half_pi = 0;  // axis crossings: which axis
    int direction = 0;            // axis crossings: +1 rising 2theta_A, -1 falling

    friend bool operator==(const Event&, const Event&) = default;
};

// All events of a track in the order of time. Crossings inside the noise of the angle count once:
// the angle has to leave the axis by more than six standard deviations on both sides. Windows with
// Flag::moving cross nothing: their angle's branch may be another.
std::vector<Event> find_events(const Track& track);

}  // namespace vybeg
