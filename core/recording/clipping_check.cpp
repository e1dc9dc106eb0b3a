#include "core/recording/clipping_check.h"

#include <cmath>
#include <limits>

namespace vybeg {
namespace {

// Frames: hundreds of periods of a carrier, a tenth of what carrier and rate usually have in
// common.
constexpr std::int64_t neighbourhood = 4096;

}  // namespace

void ClippingCheck::Extreme::add(std::int64_t frame, double value) {
    if (value > level) {
        next = level;
        next_count = count;
        level = value;
        count = 0;
        neighbours = 0;
        places.clear();
    }
    if (value == level) {
        neighbours += count > 0 && frame - last_frame <= neighbourhood ? 1 : 0;
        last_frame = frame;
        ++count;
        if (!places.empty() && places.back().first + places.back().count == frame) {
            ++places.back().count;
        } else if (places.size() < most_places) {
            places.push_back({frame, 1});
        }
    } else if (value > next) {
        next = value;
        next_count = 1;
    } else if (value == next) {
        ++next_count;
    }
}

bool ClippingCheck::Extreme::is_rail() const {
    // A sinusoid that just reaches its top level spends (sqrt(2) - 1) = 0.41 of that time on the
    // next one; noise only evens them out. Continuous samples never meet the same extreme five
    // times by chance, but a noiseless simulation does, once in each common period of carrier and
    // rate: never in clusters.
    return count >= 5 && count > 5 * next_count && 2 * neighbours >= count;
}

void ClippingCheck::add(std::int64_t first_frame, std::span<const double> x) {
    std::int64_t frame = first_frame;
    for (const double value : x) {
        if (std::isfinite(value)) {
            if (!any_) {
                constexpr double lowest = std::numeric_limits<double>::lowest();
                upper_.level = upper_.next = lower_.level = lower_.next = lowest;
                any_ = true;
            }
            // Most samples lie far inside: two comparisons decide.
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

std::vector<ClippingCheck::Rail> ClippingCheck::rails() const {
    std::vector<Rail> rails;
    // A constant channel is no clipped one.
    if (!any_ || upper_.level == -lower_.level) {
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
