#pragma once

#include "core/resonator/phasor_model.h"

#include <optional>
#include <span>

namespace vybeg {

// Where the fits begin, all from the data alone.

// Each run's frequency and start under given rates: the phasors are carried back by exp(-N t), the
// frequency is the mean turn of what remains over lags that grow, the start is linear.
FitState runs_under(std::span<const ScaledRun> runs, const SlowRates& rates);

// No difference between the modes: decay from the power, rotation from the wave angle.
FitState still_start(std::span<const ScaledRun> runs);

// The best of all matrix pencils: z(t + lag) = E z(t) in least squares over one run or over all, M
// = log(E)/lag, for lags from one window to a third of the run, and those of delayed_pencil.h. They
// find resolved pairs; where the wave hardly moves, there is none, or it is no good.
std::optional<FitState> pencil_start(std::span<const ScaledRun> runs);

}  // namespace vybeg
