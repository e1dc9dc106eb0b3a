#pragma once

#include "core/resonator/model/phasor_model.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vybeg {

// The rates of a resolved pair from one run whose two channels may see nearly the same mixture of
// its modes, as two microphones do: z(t), z(t + delay), z(t + 2 delay), ... stacked into one vector
// lie in the plane of two modes, found as the two largest principal directions; there the step by
// one window is a 2x2 matrix, and its eigenvalues are the modes' (Roy and Kailath's ESPRIT). Their
// shapes follow in least squares. `z`: the run's phasors without the mean turn; `delay` in windows.
// Nothing where the windows are too few or both modes have one shape.
std::optional<SlowRates> delayed_pencil(const ScaledRun& run,
                                        const std::vector<Eigen::Vector2cd>& z, std::size_t delay);

}  // namespace vybeg
