#pragma once

#include "core/base/job_control.h"
#include "core/resonator/results/resonator_fit.h"

#include <span>

namespace vybeg {

// Verdicts on recordings that are no free decay, where the fit of the set leaves more than noise,
// refuses the set or leaves one out of it:
// - held or driven: the amplitude grows, or stays while those of the other recordings fall;
// - friction: the amplitude falls by another law than the exponential one (decay.h), and this
//   law leaves less of it than the fit of the recording alone;
// - only a part decays: a middle part fits alone, what lies outside departs from its continuation,
//   and is no free decay of similar rate by itself (that is an event inside the recording).
// Adds warnings, and the laws to the runs. `runs`: those of the fit.
void judge_free_decay(std::span<const PhasorRun> runs, const FitOptions& options,
                      const JobControl& job, ResonatorFit& fit);

// The modes of recordings of which one shows the same projection in both channels
// (sum_of_modes.h), without axes: means over the recordings, with the deviations of their scatter.
// Errors: fit_failed.
Result<ResonatorFit> fit_one_projection(std::span<const PhasorRun> runs);

}  // namespace vybeg
