#pragma once

#include "core/track/track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace vybeg::ui {

// An interval of an axis, lower < upper.
struct AxisRange {
    double lower = 0;
    double upper = 1;

    double span() const { return upper - lower; }
    bool contains(double x) const { return lower <= x && x <= upper; }

    friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

// The least and the greatest of finite numbers; without any, low > high.
struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
};

// State of a track view: time range in seconds, and value ranges fixed by the user, in displayed
// units; the other value axes follow the data.
struct ZoomState {
    AxisRange time;
    std::map<SlowVariable, AxisRange> fixed;

    friend bool operator==(const ZoomState&, const ZoomState&) = default;
};

}  // namespace vybeg::ui
