#pragma once

#include "core/resonator/model_fit.h"
#include "core/resonator/reason.h"

#include <span>
#include <vector>

namespace vybeg {

// What the frequency does besides standing still: a drift of each run with time, a dependence on
// |z|^2 common to all. The fit keeps a term where it is beyond four deviations of chance and takes
// away at least half of what the residual has above the noise: in a residual that comes from
// elsewhere (a third mode in the band, a strike) every term is significant.
struct DriftChoice {
    ModelSpace space;
    ModelFit fit;
    std::vector<Estimate> drift_hz_per_s;  // one for each run
    Estimate frequency_per_power;          // Hz per squared scaled amplitude
};

// `drifting` is the fit of `space`, which has the drifts free. `with_power`: whether to look for a
// dependence on |z|^2. Errors as of fit_model().
Result<DriftChoice> choose_drift(std::span<const ScaledRun> runs, const ModelSpace& space,
                                 const ModelFit& drifting, bool with_power, const JobControl& job);

}  // namespace vybeg
