#pragma once

#include "core/estimators/batch/projection_kernels.h"

#include <cstddef>

namespace vybeg {

// Move of hop sums, each with its own distance, to one centre and another reference frequency.
struct HopMove {
    double n = 0;         // samples of a window
    double w = 0;         // new reference frequency, rad per sample
    double x = 0;         // new reference frequency less the old one, times n/2
    double distance = 0;  // from the new centre to that of the first hop sum, samples
    double step = 0;      // increase of the distance per hop sum, samples
};

// Moves the sums first .. first + count - 1 of `from` into the first ones of `to`. Each is moved
// separately, so that a missing sample affects its own sum only. Relative error at the distance x
// from the reference: (x v)^8/8!, v the largest distance of a sample from the centre of its sum, in
// half windows.
void move_hops(HopSums& to, const HopSums& from, std::size_t first, std::size_t count,
               const HopMove& move);

// Sums of windows 0 .. count - 1. Window k consists of the terms k .. k + whole - 1, all of one
// centre, and of heads[k]. The part common to all windows is summed once, the part on its left from
// right to left, the part on its right from left to right. Precondition: count <= whole.
void sum_windows(HopSums& windows, const HopSums& terms, const HopSums& heads, bool has_heads,
                 std::size_t whole, std::size_t count);

}  // namespace vybeg
