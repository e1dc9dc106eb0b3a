#pragma once

#include "core/resonator/model/reason.h"

namespace vybeg {

// Decay time of a decay rate (1/s) with its standard deviation and combined uncertainty, given from
// five deviations on, because 1/x is biased below. Otherwise the reason: limits of two deviations,
// or a growing motion.
Estimate decay_time(double per_s, double sd, double u);

}  // namespace vybeg
