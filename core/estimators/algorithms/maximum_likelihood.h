#pragma once

#include "core/estimators/wave/estimator.h"

namespace vybeg {

// Algorithm 6: least squares over all five parameters by variable projection (METHOD section 5.6),
// which in white noise is maximum likelihood. Exact for every window of at least least_window()
// samples.
std::unique_ptr<Estimator> make_maximum_likelihood(const EstimatorOptions& options);

}  // namespace vybeg
