#pragma once

#include "core/base/diagnostic.h"
#include "core/resonator/fit/posterior.h"

#include <optional>
#include <span>

namespace vybeg {

// What the model lacks where its residual is above the noise: the one cause whose small effect on
// the phasors takes most of the residual away, beside what the parameters follow of it (a score
// test). Causes: a damping that follows the amplitude, a frequency that settles, a channel error
// that is held at zero, another mode within the windows' band. None where no cause takes the larger
// part, or where chi^2 is that of noise. `fine`: the runs before their windows were merged,
// which tell a mode's frequency from its aliases; `scale`: recording units of a scaled one.
std::optional<Diagnostic> misfit_cause(const FitProblem& problem, const Posterior& posterior,
                                       std::span<const PhasorRun> fine, double scale);

}  // namespace vybeg
