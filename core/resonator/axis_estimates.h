#pragma once

#include "core/resonator/delta_method.h"

namespace vybeg {

// A pair of rates (v cos 4x, v sin 4x) as size v >= 0 and axis x in (-pi/4, pi/4].
struct AxisEstimate {
    Estimate size;
    Estimate axis;  // reason below_noise where v is less than five of its deviations
};

// `first` is the place of the cosine in the shared parameters; the sine follows. Where the pair is
// below its noise, the size has no slope: its deviation is then the greatest of the pair's, so that
// size and deviation together are an upper bound.
AxisEstimate axis_estimate(const DeltaMethod& delta, const Shared& shared, int first);

}  // namespace vybeg
