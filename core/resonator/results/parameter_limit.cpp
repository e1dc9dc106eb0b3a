#include "core/resonator/results/parameter_limit.h"

#include "core/resonator/results/uncertainty_budget.h"

#include <algorithm>
#include <iterator>

namespace vybeg {

Conformity conformity(const Estimate& estimate, const ParameterLimit& limit) {
    const double half = coverage_factor * estimate.uncertainty();
    if (!estimate.given() || !(half >= 0)) {
        return Conformity::unknown;
    }
    const double least = estimate.value - half;
    const double most = estimate.value + half;
    if ((limit.lower && most < *limit.lower) || (limit.upper && least > *limit.upper)) {
        return Conformity::outside;
    }
    const bool keeps =
        (!limit.lower || least >= *limit.lower) && (!limit.upper || most <= *limit.upper);
    return keeps ? Conformity::within : Conformity::unknown;
}

const ParameterLimit* limit_of(const std::vector<ParameterLimit>& limits, const char* parameter) {
    const auto found = std::ranges::find(limits, parameter, &ParameterLimit::parameter);
    return found == limits.end() ? nullptr : &*found;
}

std::vector<ResonatorParameter> limited_parameters() {
    std::vector<ResonatorParameter> limited;
    limited.reserve(resonator_parameters.size());
    std::ranges::copy_if(resonator_parameters, std::back_inserter(limited),
                         [](const ResonatorParameter& each) { return each.period == 0; });
    return limited;
}

}  // namespace vybeg
