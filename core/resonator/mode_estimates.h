#pragma once

#include "core/resonator/delta_method.h"
#include "core/resonator/resonator_fit.h"

#include <vector>

namespace vybeg {

// The eigenvalues of M by falling frequency, about the mean frequency `f_hz` whose gradient is
// `f_by`; none where their difference is less than five of its deviations.
std::vector<ModeEstimate> mode_estimates(const DeltaMethod& delta, const Shared& shared,
                                         double f_hz, const Eigen::VectorXd& f_by);

}  // namespace vybeg
