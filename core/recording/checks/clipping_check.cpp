#include "core/recording/checks/clipping_check.h"

#include <algorithm>
#include <cmath>
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
        next = level;
        next_count = count;
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
    } else if (value > next) {
        next = value;
        next_count = 1;
    } else if (value == next) {
        ++next_count;
    }
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
    // next one; noise only equalises them. Continuous samples never repeat the same extreme five
    // times by chance. A noiseless simulation does, once in each common period of carrier and rate,
    // but never in clusters.
    return count >= 5 && count > 5 * next_count && 2 * neighbours >= count &&
           common < longest_pattern;
}

void ClippingCheck::add(std::int64_t first_frame, std::span<const double> x) {
    std::int64_t frame = first_frame;
    for (const double value : x) {
        if (std::isfinite(value)) {
            if (count_ == 0) {
                constexpr double lowest = std::numeric_limits<double>::lowest();
                upper_.level = upper_.next = lower_.level = lower_.next = lowest;
            }
            ++count_;
            // Most samples lie far inside, where two comparisons are enough.
            if (value >= upper_.next) {
                upper_.add(frame, value);
            }
            if (-value >= lower_.next) {
                lower_.add(frame, -value);
            }
        }
        ++frame;
    }
}

bool ClippingCheck::are_inside(double lowest, double highest) const {
    return count_ > 0 && highest < upper_.next && -lowest < lower_.next;
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
