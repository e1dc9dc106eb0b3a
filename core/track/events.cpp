#include "core/track/events.h"

#include "core/numerics/statistics.h"
#include "core/track/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vybeg {
namespace {

constexpr double half_pi = std::numbers::pi / 2;

// Time at which 2theta_A crosses `level`, s; it lies on opposite sides of `level` at the windows
// `before` and `after`.
double time_at(const Track& track, std::size_t before, std::size_t after, double level) {
    const auto time = track.time_s();
    const auto angle = track.values(SlowVariable::two_theta_A);
    const std::size_t width = after - before;
    const std::size_t from = before - std::min(before, width - 1);
    const std::size_t count = std::min(after + width, track.rows()) - from;
    const LineFit line = fit_line(time.subspan(from, count), angle.subspan(from, count));
    const double at = line.mean_x + (level - line.mean_y) / line.slope;
    // The line is inaccurate for a fast turn; the crossing lies between the two windows.
    return std::clamp(at, time[before], time[after]);
}

// Standard deviations of 2theta_A, each averaged over its neighbours: in a short window the
// deviation itself is known to no more than a third.
std::vector<double> local_sds(std::span<const double> sds) {
    constexpr std::size_t reach = 50;
    std::vector<double> sum(sds.size() + 1);
    std::vector<double> count(sds.size() + 1);
    for (std::size_t k = 0; k < sds.size(); ++k) {
        const bool valid = std::isfinite(sds[k]);
        sum[k + 1] = sum[k] + (valid ? sds[k] : 0);
        count[k + 1] = count[k] + (valid ? 1 : 0);
    }
    std::vector<double> local(sds.size());
    for (std::size_t k = 0; k < sds.size(); ++k) {
        const std::size_t from = k - std::min(k, reach);
        const std::size_t to = std::min(k + reach + 1, sds.size());
        local[k] = (sum[to] - sum[from]) / std::max(count[to] - count[from], 1.0);
    }
    return local;
}

// Whether the angle of a moving window goes on from the row before: the motion inside it is small,
// and the phase confirms a small step.
bool follows(const Track& track, std::size_t row) {
    constexpr double largest_share = 0.05;  // of the amplitude, left by the motion
    if (row == 0) {
        return false;
    }
    const MotionMarker::Row from = MotionMarker::row_of(track, row - 1);
    const MotionMarker::Row to = MotionMarker::row_of(track, row);
    const std::optional<double> off =
        MotionMarker::phase_off(from, to, track.time_s()[row] - track.time_s()[row - 1]);
    return to.noise < largest_share * to.a_A && off && std::abs(*off) < half_pi / 4 &&
           std::abs(to.two_theta_A - from.two_theta_A) < half_pi / 4;
}

// Axis crossings with a dead band round each axis: the angle counts as past an axis only beyond six
// standard deviations, which noise reaches once in 10^9 windows. The crossing is the intersection
// of the axis with a line through the windows between and as many on either side.
void find_crossings(const Track& track, std::vector<Event>& events) {
    const auto angle = track.values(SlowVariable::two_theta_A);
    const std::vector<double> sd = local_sds(track.sds(SlowVariable::two_theta_A));
    bool known = false;
    std::size_t last = 0;  // the last window that was clear of every axis
    for (std::size_t k = 0; k < track.rows(); ++k) {
        if (has(track.flags()[k], Flag::moving) && !follows(track, k)) {
            known = false;
            continue;
        }
        const double position = angle[k] / half_pi;
        const double clear = std::min(6 * sd[k] / half_pi, 0.4);
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
                events.push_back(
                    {std::nullopt, time_at(track, last, k, axis * half_pi), 0, axis, direction});
            }
        }
        last = k;
        known = true;
    }
}

// Events of consecutive windows with a flag.
void find_segments(const Track& track, Flag flag, std::vector<Event>& events) {
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
        events.push_back({flag, time[first], time[k] - time[first], 0, 0});
    }
}

}  // namespace

std::vector<Event> find_events(const Track& track) {
    std::vector<Event> events;
    find_crossings(track, events);
    for (const Flag flag : {Flag::gap, Flag::clipped, Flag::not_converged, Flag::filter_transient,
                            Flag::delay_reach, Flag::moving}) {
        find_segments(track, flag, events);
    }
    std::stable_sort(events.begin(), events.end(),
                     [](const Event& a, const Event& b) { return a.time_s < b.time_s; });
    return events;
}

}  // namespace vybeg
