#pragma once

#include "core/resonator/model/phasor_model.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vybeg {

// Rates of a resolved pair from one run whose channels may contain nearly the same mixture of its
// modes, such as two microphones (ESPRIT, Roy and Kailath). The stacked vectors z(t), z(t + delay),
// z(t + 2 delay), ... lie in the plane of two modes, the two largest principal directions. There
// the step by one window is a 2x2 matrix with the eigenvalues of the modes; their shapes follow by
// least squares. `z`: the run's phasors without the mean rotation; `delay` in windows. Empty for
// too few windows or two modes of one shape.
std::optional<SlowRates> delayed_pencil(const ScaledRun& run,
                                        const std::vector<Eigen::Vector2cd>& z, std::size_t delay);

}  // namespace vybeg
