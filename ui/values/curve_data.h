#pragma once

#include "core/analysis/analysis.h"
#include "ui/values/zoom_state.h"
#include "ui/words/display_units.h"

#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace vybeg::ui {

// The windows of one pixel column, or one window where they are farther apart: stored units.
struct CurveColumn {
    double time_first = 0;  // of the first and last window with a value
    double time_last = 0;
    double first = std::numeric_limits<double>::quiet_NaN();
    double last = std::numeric_limits<double>::quiet_NaN();
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    double sum = 0;                                             // of the values
    std::size_t count = 0;                                      // of the windows with a value
    double band_min = std::numeric_limits<double>::infinity();  // of value - sd and value + sd
    double band_max = -std::numeric_limits<double>::infinity();
    // Of the values below and above the middle, for angles that make a turn inside the column.
    double negative_max = -std::numeric_limits<double>::infinity();
    double positive_min = std::numeric_limits<double>::infinity();
    bool wraps = false;
    bool joined = false;   // connected by a line to the column before
    bool missing = false;  // at least one window has no value

    bool empty() const { return !(min <= max); }
};

// Appends a column that follows in time; values farther apart than half a turn wrap.
void append(CurveColumn& column, const CurveColumn& next, double half_turn = std::numbers::pi);

// One variable of one analysis for drawing: least and greatest value of every pixel column without
// reading each window, from summaries of 64, 64 times 64, ... windows. Immutable; keeps the
// analysis with its track alive.
class CurveData {
public:
    // The values of an angle are those on the branch of `scale`.
    CurveData(std::shared_ptr<const Analysis> analysis, SlowVariable variable,
              const DisplayScale& scale = {});
    CurveData(const CurveData&) = delete;
    CurveData& operator=(const CurveData&) = delete;

    // Visible part between two times (s) in `count` equal columns, plus one column beyond each end;
    // columns without a window are omitted. Columns begin at whole multiples of their width, so
    // that panning does not make the curve flicker. Precondition: count >= 1.
    std::vector<CurveColumn> columns(const AxisRange& time, int count) const;

    // The window nearest to a time; precondition: the track has rows.
    std::size_t nearest(double time_s) const;
    double time(std::size_t row) const { return time_[row]; }
    // Of delta_phi_CD, where its values keep together, the one next to their middle modulo a turn.
    double value(std::size_t row) const { return value_[row]; }

    // Whether no window has a value.
    bool empty() const { return empty_; }
    std::size_t rows() const { return time_.size(); }
    SlowVariable variable() const { return variable_; }
    const Analysis& analysis() const { return *analysis_; }

private:
    static constexpr std::size_t fan = 64;  // rows in a block, blocks in one of the next level

    void joinTurns();
    void addRows(CurveColumn& column, std::size_t begin, std::size_t end) const;
    CurveColumn summarise(std::size_t begin, std::size_t end) const;

    std::shared_ptr<const Analysis> analysis_;
    SlowVariable variable_;
    std::span<const double> time_;
    std::span<const double> value_;
    std::span<const double> sd_;
    bool wrapped_ = false;
    double half_turn_ = std::numbers::pi;
    double middle_ = 0;           // of an angle
    std::vector<double> joined_;  // its values, if they are not those of the track
    bool empty_ = true;
    std::vector<std::vector<CurveColumn>> levels_;
};

// The curves of all slow variables, in their order.
using Curves = std::vector<std::shared_ptr<const CurveData>>;
Curves curvesOf(const std::shared_ptr<const Analysis>& analysis);

// Whether the windows of an analysis reach this time: at most a window's length before the first
// centre or after the last one. A single window counts as everywhere.
bool covers(const Analysis& analysis, double time_s);

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
