#pragma once

#include "core/base/job_control.h"
#include "core/resonator/fit/map_fit.h"
#include "core/resonator/results/given_or_refused.h"
#include "core/resonator/results/resonator_result.h"

#include <span>

namespace vybeg {

// A set of runs with its most likely parameters.
struct SolvedSet {
    std::span<const PhasorRun> runs;  // as fitted
    std::span<const PhasorRun> fine;  // before their windows were merged
    const FitProblem* problem = nullptr;
    MapFit fit;
    ResonatorModel model{};
    double scale = 1;                // recording units of a scaled unit
    Estimate cubic_limit;            // b and its sd where it is held at zero; scaled units
    bool amplitude_or_time = false;  // settling frequencies explain the phasors as well as b
    RunDeviation spread;             // sd of the deviations of the runs from the set
    ChannelTolerance tolerance;      // told or assumed: the sizes of the errors in u
};

FittedMotion motion_of(const SolvedSet& set);

// Results for the resonator and for each run, with deviations and warnings. A fit that has not
// converged yields no number, only its motion and the warning.
ResonatorFit describe(const SolvedSet& set, const JobControl& job);

// The warning that names a break.
Diagnostic break_finding(const FittedBreak& found);

}  // namespace vybeg
