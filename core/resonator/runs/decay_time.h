#pragma once

#include "core/resonator/model/reason.h"

namespace vybeg {

// The decay time of a decay rate (1/s) with its standard deviation and combined uncertainty: given
// from five deviations on, because 1/x is biased below. Else limits of two deviations, or that the
// motion grows.
Estimate decay_time(double per_s, double sd, double u);

}  // namespace vybeg
