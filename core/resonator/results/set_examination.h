#pragma once

#include "core/resonator/fit/map_fit.h"
#include "core/resonator/fit/run_information.h"
#include "core/resonator/results/resonator_result.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vybeg {

// Whether the runs of a set are of one resonator (FIT section 10). A set is a hypothesis: it is
// tested before its numbers are believed.
enum class SetVerdict {
    fits,     // the runs agree
    spread,   // 1/tau, split and gain ratio differ a little from run to run
    foreign,  // without one run the others agree
    several,  // so they do without either of two or more
    refused   // no single run makes the difference
};

struct SetExamination {
    SetVerdict verdict = SetVerdict::fits;
    std::vector<std::size_t> foreign;  // the suspects, the likeliest first
    double cost = 0;                   // of the others and the likeliest, each alone
    bool by_channels = false;  // other channels of one run fit better: no common cause does that
    // What makes the likeliest one of the set again, or which of its numbers disagrees: words.
    MessageArg cause;
    Spread spread;  // of verdict `spread`; of other sets that agree the sd alone
    // Largest variance of a run's noise in the fit of this run alone, in units of its windows'.
    double own_noise = 1;

    // Whether the runs are those of one resonator.
    bool agrees() const { return verdict == SetVerdict::fits || verdict == SetVerdict::spread; }
};

// `joint`: the fit of `problem`. A set whose runs agree takes one look at the information of each;
// otherwise each run is fitted alone, and the set without each of the four that disagree most and
// without the one that its own fit leaves far above its noise.
// `spread`: of FitOptions, for sets that agree.
SetExamination examine_set(const FitProblem& problem, const MapFit& joint,
                           std::optional<double> spread, const JobControl& job);

// Result for a set whose misfit has a cause that all runs share.
SetExamination agreeing_set(const FitProblem& problem, const MapFit& joint,
                            std::optional<double> spread, const JobControl& job);

// Puts the findings about a set before the other warnings; `assumed`: its spread is assumed, where
// the runs agree.
void add_findings(const SetExamination& examination, bool assumed, ResonatorFit& fit);

// The same of a set that stays whole: without agreement it has no numbers.
void conclude(SetExamination examination, bool assumed, ResonatorFit& fit);

}  // namespace vybeg
