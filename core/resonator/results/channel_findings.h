#pragma once

#include "core/base/diagnostic.h"
#include "core/resonator/results/fitted_set.h"

#include <vector>

namespace vybeg {

// Arguments of a warning about a channel error: its name and its size in the parameter's unit.
std::vector<MessageArg> named_error(const ToleratedError& error, double size, double f_ref_hz);

// Warnings about the channels of a structured fit, each for errors of more than three tolerances:
// - an error that the fit has moved from its prior by more (prior_left);
// - an error held at zero that a score test of the residual shows if all of them are opened, each
//   with its tolerance (misfit_channel);
// - a delay or crosstalk that the quadratures at the starts of four recordings or more follow by
//   their angles (quadrature_by_channel). The motion does not show it: it looks like a rotation;
// - a rotation faster than the Earth's, which a delay beyond its tolerance may look like
//   (rotation_or_channel).
// And an anisotropy that reaches that of a passive resonator. `white`: the residual is noise.
std::vector<Diagnostic> channel_findings(const FittedSet& set, const ResonatorFit& fit, bool white);

}  // namespace vybeg
