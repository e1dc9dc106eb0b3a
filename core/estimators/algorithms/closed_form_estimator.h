#pragma once

#include "core/estimators/wave/estimator.h"
#include "core/estimators/wave/window_moments.h"

namespace vybeg {

// The article's algorithms 1 to 4: four parameters in closed form at a given frequency, and the
// frequency from the minimum of J, (16), (25), (29), in one parameter.
std::unique_ptr<Estimator> make_closed_form(Algorithm algorithm, const EstimatorOptions& options);

// The in-phase closed forms (15), (18) of one window at a given frequency: the start values of
// algorithm 5.
WaveState in_phase_start(const Window& window, double w);

}  // namespace vybeg
