#pragma once

#include <limits>

namespace vybeg {

// Seconds from the start of the recording; all of it, where nothing is said.
struct TimeRange {
    double from_s = -std::numeric_limits<double>::infinity();
    double to_s = std::numeric_limits<double>::infinity();

    friend bool operator==(const TimeRange&, const TimeRange&) = default;
};

}  // namespace vybeg
