#pragma once

#include "core/estimators/batch/projection_kernels.h"

#include <cstddef>

namespace vybeg {

// Runs of samples, each with its own distance, to one centre and another reference frequency.
struct HopMove {
    double n = 0;         // samples of a window
    double w = 0;         // the frequency to which they come, rad per sample
    double x = 0;         // by how much it lies above theirs, times n/2
    double distance = 0;  // by how many samples the new centre lies before that of the first run
    double step = 0;      // by how many more for each further one
};

// Of `from`, the runs first .. first + count - 1 into the first ones of `to`. Each is read for
// itself: a missing sample stays in its run. What a series says x away from its reference is right
// to (x v)^8/8!, v the farthest of the run's samples from its centre, in halves of a window.
void move_hops(HopSums& to, const HopSums& from, std::size_t first, std::size_t count,
               const HopMove& move);

// Windows of `whole` runs, the first one of windows 0 .. count - 1 being runs 0 .. count - 1 of
// `terms`, all of which have one centre: what the windows share is summed up once, what is left of
// it from there to the left, what is right of it to the right. `heads` are added one for each
// window. Precondition: count <= whole.
void sum_windows(HopSums& windows, const HopSums& terms, const HopSums& heads, bool has_heads,
                 std::size_t whole, std::size_t count);

}  // namespace vybeg
