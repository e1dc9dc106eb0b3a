#pragma once

#include "core/resonator/results/given_or_refused.h"

#include <span>

namespace vybeg {

// The fitted parameters that are not held, in recording units, with their covariance of all parts.
RawParameters raw_parameters(const FittedSet& set, std::span<const PhasorRun> runs);

}  // namespace vybeg
