#pragma once

#include "core/track/slow_variables.h"

#include <cstddef>
#include <map>
#include <vector>

namespace vybeg::ui {

// An interval of an axis, lower < upper.
struct AxisRange {
    double lower = 0;
    double upper = 1;

    double span() const { return upper - lower; }
    bool contains(double x) const { return lower <= x && x <= upper; }

    friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

// State of a track view: time range in seconds, and value ranges fixed by the user, in displayed
// units; the other value axes follow the data.
struct ZoomState {
    AxisRange time;
    std::map<SlowVariable, AxisRange> fixed;

    friend bool operator==(const ZoomState&, const ZoomState&) = default;
};

// History of views, as in a browser. A value without widgets.
class ZoomStack {
public:
    explicit ZoomStack(ZoomState home = {}) : states_{std::move(home)} {}

    const ZoomState& current() const { return states_[position_]; }
    bool canBack() const { return position_ > 0; }
    bool canForward() const { return position_ + 1 < states_.size(); }

    // Goes to a new view and removes the forward entries. With `same_gesture` it replaces the
    // current entry, so that one turn of the wheel is one step back.
    void visit(ZoomState state, bool same_gesture = false);
    void back();
    void forward();

private:
    std::vector<ZoomState> states_;
    std::size_t position_ = 0;
};

}  // namespace vybeg::ui
