#pragma once

#include "core/base/diagnostic.h"
#include "core/resonator/fit/posterior.h"

#include <optional>
#include <span>

namespace vybeg {

// Cause of a residual above the noise: the one whose small effect on the phasors explains most of
// the residual, besides the part absorbed by the parameters (a score test). Causes: a damping that
// follows the amplitude, a frequency that settles, a channel error that is held at zero, another
// mode within the windows' band. None if no cause explains the larger part, or if chi^2 is that of
// noise. `fine`: the runs before merging of windows, which distinguish a mode's frequency from its
// aliases; `scale`: recording units of a scaled unit.
std::optional<Diagnostic> misfit_cause(const FitProblem& problem, const Posterior& posterior,
                                       std::span<const PhasorRun> fine, double scale);

// Words for a damping whose rate follows the amplitude to a power.
MessageArg friction_words(double exponent);

}  // namespace vybeg
