#pragma once

#include "ui/values/curve_data.h"
#include "ui/words/display_units.h"

#include <optional>
#include <vector>

namespace vybeg::ui {

// Gathers what the visible columns of several curves reach, and finds the value axis that shows
// them well: all of the data unless single spikes stand far out, the bands of one standard
// deviation as long as they do not flatten the data, a margin around.
class ValueRange {
public:
    void add(const std::vector<CurveColumn>& columns, const DisplayScale& scale, bool bands);

    // In displayed units; nothing where there is no value.
    std::optional<AxisRange> range(bool logarithmic) const;

private:
    std::vector<double> lows_;
    std::vector<double> highs_;
    std::vector<double> band_lows_;
    std::vector<double> band_highs_;
};

// The interval [low, high] of stored values in displayed units, in order. In decibels an interval
// around zero has no lower end: it gets that of its larger side less 60 dB.
AxisRange displayedInterval(const DisplayScale& scale, double low, double high);

}  // namespace vybeg::ui
