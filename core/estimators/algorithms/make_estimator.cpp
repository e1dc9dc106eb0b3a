#include "core/estimators/algorithms/closed_form.h"
#include "core/estimators/algorithms/conjugate_gradient.h"
#include "core/estimators/algorithms/maximum_likelihood.h"

namespace vybeg {

std::unique_ptr<Estimator> make_estimator(Algorithm algorithm, const EstimatorOptions& options) {
    switch (algorithm) {
        case Algorithm::in_phase: return make_in_phase(options);
        case Algorithm::phase_shift: return make_phase_shift(options);
        case Algorithm::moving_axes: return make_moving_axes(options);
        case Algorithm::demodulation: return make_demodulation(options);
        case Algorithm::conjugate_gradient: return make_conjugate_gradient(options);
        case Algorithm::maximum_likelihood: return make_maximum_likelihood(options);
    }
    return nullptr;
}

}  // namespace vybeg
