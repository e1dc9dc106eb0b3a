#pragma once

#include "core/resonator/delta_method.h"
#include "core/resonator/resonator_fit.h"

#include <vector>

namespace vybeg {

// Amplitudes and angle of a run at the start of its recording, and split * sin 4(theta_A - theta_w)
// there. The start is freed from the mean over the windows; that mean being next to 1, its own
// deviation is left out. The rest of the estimate is left to the caller.
RunEstimate run_estimate(const DeltaMethod& delta, const FitState& state, std::size_t run,
                         double window_s, double scale);

// Q from the envelope, at the frequency `f_hz`; warns where it disagrees with the fitted motion by
// more than three deviations.
void envelope_estimate(RunEstimate& estimate, const ScaledRun& scaled, const FitState& state,
                       std::size_t run, double f_hz, double enlargement,
                       std::vector<Diagnostic>& warnings);

}  // namespace vybeg
