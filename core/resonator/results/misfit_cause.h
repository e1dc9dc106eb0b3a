#pragma once

#include "core/base/diagnostic.h"
#include "core/base/job_control.h"
#include "core/resonator/results/fitted_set.h"

#include <optional>

namespace vybeg {

// Cause of a residual above the noise: the one whose small effect on the phasors explains most of
// the residual, besides the part absorbed by the parameters (a score test). Causes: a damping that
// follows the amplitude, a frequency that settles, a channel error that is held at zero, springs
// unlike along the axes, another mode within the windows' band or, where it leaves only noise,
// nearer than three cycles to the wave. None if no cause explains the larger part, or if chi^2 is
// that of noise. The runs before merging of windows distinguish a mode's frequency from its
// aliases. A cancelled job ends the search early.
struct MisfitCause {
    Diagnostic diagnostic;
    double fall = 0;  // of chi^2
};
enum class Causes { all, without_lines };
std::optional<MisfitCause> misfit_cause(const FittedSet& set, const Posterior& posterior,
                                        Causes causes, const JobControl& job);

// Words for a damping whose rate follows the amplitude to a power.
MessageArg friction_words(double exponent);

}  // namespace vybeg
