#pragma once

#include "core/track/track.h"

#include <cstddef>

namespace vybeg {

// What one line says about a whole track.
struct TrackSummary {
    std::size_t windows = 0;
    std::size_t flagged = 0;  // windows with a reason other than no_quadrature
    double mean_f_hz = 0;     // of the windows without Flag::gap; NaN where none has a frequency
    double sd_mean_f_hz = 0;  // from the scatter between windows; NaN for fewer than two windows
    double rms = 0;           // root of the mean of F over the windows, recording units; NaN: none
};

// `independent` is the fraction of a window's samples that the next one does not share, hop /
// length and at most 1: overlapping windows tell less about their mean than their number promises.
TrackSummary summarise(const Track& track, double independent);

}  // namespace vybeg
