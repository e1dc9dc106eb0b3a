#include "core/estimators/algorithms/algorithms.h"

namespace vybeg {

std::unique_ptr<Estimator> make_estimator(Algorithm algorithm, const EstimatorOptions& options) {
    switch (algorithm) {
        case Algorithm::in_phase:
        case Algorithm::phase_shift:
        case Algorithm::moving_axes:
        case Algorithm::demodulation: return make_closed_form(algorithm, options);
        case Algorithm::conjugate_gradient: return make_conjugate_gradient(options);
        case Algorithm::maximum_likelihood: return make_maximum_likelihood(options);
    }
    return nullptr;
}

}  // namespace vybeg
