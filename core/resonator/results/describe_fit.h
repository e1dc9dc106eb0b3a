#pragma once

#include "core/base/job_control.h"
#include "core/resonator/results/fitted_set.h"

namespace vybeg {

FittedMotion motion_of(const FittedSet& set);

// Results for the resonator and for each run, with deviations and warnings. A fit that has not
// converged yields no number, only its motion and the warning.
ResonatorFit describe(const FittedSet& set, const JobControl& job);

}  // namespace vybeg
