#pragma once

#include "ui/values/curve_data.h"
#include "ui/words/display_units.h"

#include <optional>
#include <vector>

namespace vybeg::ui {

// Automatic value axis from the visible columns of several curves: all data except single far
// spikes, the bands of one standard deviation unless they flatten the data, and a margin.
class ValueRange {
public:
    void add(const std::vector<CurveColumn>& columns, const DisplayScale& scale, bool bands);

    // Range in displayed units; empty without values.
    std::optional<AxisRange> range(bool logarithmic) const;

private:
    std::vector<double> lows_;
    std::vector<double> highs_;
    std::vector<double> band_lows_;
    std::vector<double> band_highs_;
};

// The interval [low, high] of stored values in displayed units, in order. In decibels an interval
// around zero has no lower end; it gets the larger side less 60 dB.
AxisRange displayedInterval(const DisplayScale& scale, double low, double high);

}  // namespace vybeg::ui
