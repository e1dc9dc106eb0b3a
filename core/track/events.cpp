#include "core/track/events.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

constexpr double half_pi = std::numbers::pi / 2;

// Axis crossings with a dead band round each axis: the angle counts as beyond an axis only when it
// is three standard deviations past it; the crossing itself is interpolated between the last window
// on the one side and the first on the other.
void find_crossings(const Track& track, std::vector<Event>& events) {
    const auto time = track.time_s();
    const auto angle = track.values(SlowVariable::two_theta_A);
    const auto sd = track.sds(SlowVariable::two_theta_A);
    bool known = false;
    std::size_t last = 0;  // the last window that was clear of every axis
    for (std::size_t k = 0; k < track.rows(); ++k) {
        const double position = angle[k] / half_pi;
        const double clear = std::min(3 * sd[k] / half_pi, 0.4);
        if (std::isnan(position) || std::abs(position - std::round(position)) <= clear) {
            continue;
        }
        if (known) {
            const double before = angle[last] / half_pi;
            const int direction = position > before ? 1 : -1;
            const int first_axis =
                static_cast<int>(direction > 0 ? std::ceil(before) : std::floor(before));
            const int end_axis =
                static_cast<int>(direction > 0 ? std::floor(position) : std::ceil(position));
            for (int axis = first_axis; direction * (end_axis - axis) >= 0; axis += direction) {
                const double part = (axis - before) / (position - before);
                events.push_back({EventKind::axis_crossing,
                                  time[last] + part * (time[k] - time[last]), 0, axis, direction});
            }
        }
        last = k;
        known = true;
    }
}

// Stretches of consecutive windows with a flag.
void find_stretches(const Track& track, Flag flag, EventKind kind, std::vector<Event>& events) {
    const auto time = track.time_s();
    const auto flags = track.flags();
    for (std::size_t k = 0; k < track.rows(); ++k) {
        if (!has(flags[k], flag)) {
            continue;
        }
        const std::size_t first = k;
        while (k + 1 < track.rows() && has(flags[k + 1], flag)) {
            ++k;
        }
        events.push_back({kind, time[first], time[k] - time[first], 0, 0});
    }
}

}  // namespace

std::vector<Event> find_events(const Track& track) {
    std::vector<Event> events;
    find_crossings(track, events);
    find_stretches(track, Flag::gap, EventKind::gap, events);
    find_stretches(track, Flag::not_converged, EventKind::not_converged, events);
    std::stable_sort(events.begin(), events.end(),
                     [](const Event& a, const Event& b) { return a.time_s < b.time_s; });
    return events;
}

}  // namespace vybeg
