#pragma once

#include "core/estimators/wave/estimator.h"

#include <memory>

namespace vybeg {

// Algorithm 5: the article's conjugate gradient over all five parameters at once, with the analytic
// gradient and Hessian of F.
std::unique_ptr<Estimator> make_conjugate_gradient(const EstimatorOptions& options);

}  // namespace vybeg
