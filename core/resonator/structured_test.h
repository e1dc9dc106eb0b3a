#pragma once

#include "core/base/job_control.h"
#include "core/resonator/channel_tolerance.h"
#include "core/resonator/map_fit.h"

#include <string>

namespace vybeg {

// Whether the channels are a calibrated pair (FIT section 6). The structured M with a gain ratio
// has as many numbers as a free one, so that random mixtures of two modes fit it; but for a gyro
// gain ratio, skew, damping anisotropy and rotation are small together, and for a mixture they are
// not.
struct StructuredVerdict {
    bool structured = true;
    double penalty = 0;  // squared deviations of those from small values, and the rise of chi^2
    double free_over_structured = 0;  // fall of chi^2 to the free fit, in units of its chi^2/dof
    std::string reason;               // the term that weighs most where it is refused
};

// `main`: the structured fit of `problem`; `free`: the free fit of the same runs with `free_dof`
// degrees of freedom. Larger tolerances than the test's own widths take their place.
StructuredVerdict test_structured(const FitProblem& problem, const MapFit& main, const MapFit& free,
                                  double free_dof, const ChannelTolerance& tolerance,
                                  const JobControl& job);

}  // namespace vybeg
