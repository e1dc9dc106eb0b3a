#pragma once

#include "core/analysis/analysis.h"

#include <algorithm>
#include <cstdint>

namespace vybeg {

// Consecutive frames [first, end).
struct Frames {
    std::int64_t first = 0;
    std::int64_t end = 0;

    std::int64_t count() const { return std::max<std::int64_t>(end - first, 0); }
};

// Frames that belong to a window: those of its samples whose nearest centre is its own; halfway
// between two centres the later window's.
Frames own_frames(const WindowPlan& plan, std::int64_t window);

// The window that a frame belongs to, or the first one after it; the last one behind all.
std::int64_t window_about(const WindowPlan& plan, std::int64_t frame);

// Samples of both channels, or of a wave; recording units.
struct SignalPair {
    double c = 0;
    double d = 0;
};

// The wave (6) of a window, from its row of the track. Precondition: the track has all rows of the
// plan.
class WindowWave {
public:
    WindowWave(const Analysis& analysis, std::int64_t window, double rate_hz);

    // Whether the window has a wave with an angle.
    bool exists() const;
    // NaN of a wave that does not exist. `frame` may lie between samples.
    SignalPair at(double frame) const;
    SignalPair amplitudes() const;

private:
    double cos_c_ = 0;
    double sin_c_ = 0;
    double cos_d_ = 0;
    double sin_d_ = 0;
    double alpha_ = 0;
    double step_ = 0;
    double centre_ = 0;
};

}  // namespace vybeg
