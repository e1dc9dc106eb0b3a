#include "core/recording/checks/clipping_check.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace vybeg {
namespace {

// Frames: hundreds of periods of a carrier, a tenth of what carrier and rate usually have in
// common.
constexpr std::int64_t neighbourhood = 4096;
// Frames: occurrences at multiples of more than this are the pattern of a noiseless carrier that
// nearly divides the rate (355 frames in 113 half-periods), not a rail.
constexpr std::int64_t longest_pattern = 64;

}  // namespace

void ClippingCheck::Extreme::add(std::int64_t frame, double value) {
    if (value > level) {
        if (count > 0) {
            add_below({level, count});
        }
        level = value;
        count = 0;
        neighbours = 0;
        common = 0;
        places.clear();
        drawn_together = 0;
    }
    if (value == level) {
        neighbours += count > 0 && frame - last_frame <= neighbourhood ? 1 : 0;
        common = count > 0 ? std::gcd(common, frame - last_frame) : 0;
        last_frame = frame;
        ++count;
        if (!places.empty() && frame - places.back().end() <= drawn_together) {
            places.back().count = frame + 1 - places.back().first;
        } else {
            places.push_back({frame, 1});
        }
        if (places.size() > most_places) {
            draw_together();
        }
    } else {
        add_below({value, 1});
    }
}

void ClippingCheck::Extreme::add_below(const Level& more) {
    const auto place = std::ranges::lower_bound(below, more.value, std::greater{}, &Level::value);
    if (place == below.end()) {
        return;
    }
    if (place->value == more.value) {
        place->count += more.count;
        return;
    }
    std::move_backward(place, below.end() - 1, below.end());
    *place = more;
}

// Merges neighbouring places beyond the limit until half of them remain.
void ClippingCheck::Extreme::draw_together() {
    while (places.size() > most_places / 2) {
        drawn_together = std::max<std::int64_t>(2 * drawn_together, 8);
        std::vector<FrameRange> fewer{places.front()};
        for (const FrameRange& place : places) {
            FrameRange& last = fewer.back();
            if (place.first - last.end() <= drawn_together) {
                last.count = place.end() - last.first;
            } else {
                fewer.push_back(place);
            }
        }
        places = std::move(fewer);
    }
}

bool ClippingCheck::Extreme::is_rail() const {
    // A sinusoid that just reaches its top level stays (sqrt(2) - 1) = 0.41 times as long on the
    // next one; noise only equalises them. Few samples of a fine converter may miss the next level,
    // but not all of the next ones. Continuous samples never repeat the same extreme five
    // times by chance. A noiseless simulation does, once in each common period of carrier and rate,
    // but never in clusters.
    constexpr std::int64_t least_count = 5;
    constexpr std::int64_t many = 40;  // misses the next level with a probability of 1e-6
    constexpr double few = 0.2;        // of what a sinusoid has on the next levels
    double step = std::numeric_limits<double>::infinity();
    double last = level;
    double inward = 0;
    for (const Level& each : below) {
        if (each.count > 0) {
            step = std::min(step, last - each.value);
            last = each.value;
            inward += static_cast<double>(each.count);
        }
    }
    const auto own = static_cast<double>(count);
    const double levels = 1 + (level - last) / step;  // NaN: there is no other level
    const bool missed = count < many && inward > few * own * (std::sqrt(levels) - 1);
    return count >= least_count && count > 5 * below.front().count && 2 * neighbours >= count &&
           common < longest_pattern && !missed;
}

void ClippingCheck::add(std::int64_t first_frame, std::span<const double> x) {
    std::int64_t frame = first_frame;
    for (const double value : x) {
        if (std::isfinite(value)) {
            ++count_;
            // Most samples lie far inside, where two comparisons are enough.
            if (value >= upper_.least()) {
                upper_.add(frame, value);
            }
            if (-value >= lower_.least()) {
                lower_.add(frame, -value);
            }
        }
        ++frame;
    }
}

bool ClippingCheck::are_inside(double lowest, double highest) const {
    return count_ > 0 && highest < upper_.least() && -lowest < lower_.least();
}

int ClippingCheck::levels() const {
    if (count_ == 0 || upper_.level == -lower_.level) {
        return count_ == 0 ? 0 : 1;
    }
    return upper_.count + lower_.count == count_ ? 2 : 3;
}

std::vector<ClippingCheck::Rail> ClippingCheck::rails() const {
    std::vector<Rail> rails;
    if (levels() < 3) {
        return rails;
    }
    if (upper_.is_rail()) {
        rails.push_back({upper_.level, upper_.count, upper_.places});
    }
    if (lower_.is_rail()) {
        rails.push_back({-lower_.level, lower_.count, lower_.places});
    }
    return rails;
}

}  // namespace vybeg
