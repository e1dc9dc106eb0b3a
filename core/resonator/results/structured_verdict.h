#pragma once

#include "core/base/job_control.h"
#include "core/base/message_arg.h"
#include "core/resonator/fit/map_fit.h"
#include "core/resonator/model/channel_tolerance.h"

namespace vybeg {

// Test whether the channels are a calibrated pair (FIT section 6). The structured M with a gain
// ratio has as many parameters as a free one, so random mixtures of two modes fit it. For a gyro,
// however, gain ratio, skew, damping anisotropy and rotation are small together; for a mixture they
// are not.
struct StructuredVerdict {
    bool structured = true;
    double penalty = 0;  // squared deviations of those from small values, and the rise of chi^2
    double free_over_structured = 0;  // fall of chi^2 to the free fit, in units of its noise
    MessageArg reason;                // the term of largest weight if structured is refused
};

// `main`: the structured fit of `problem`; `free`: the fit of `free_problem`, the same runs. Larger
// tolerances than the test's own widths take their place. A coloured residual of the free fit
// reduces the weight of the data by the widening of its rates.
StructuredVerdict test_structured(const FitProblem& problem, const MapFit& main,
                                  const FitProblem& free_problem, const MapFit& free,
                                  const ChannelTolerance& tolerance, const JobControl& job);

}  // namespace vybeg
