#include "core/resonator/results/resonator_parameters.h"

#include <algorithm>

namespace vybeg {

std::vector<ParameterBudget> uncertainty_budget(const ResonatorFit& fit) {
    std::vector<ParameterBudget> budget;
    for (std::size_t k = 0; k < fit.shares.size(); ++k) {
        const ResonatorParameter& parameter = resonator_parameters[k];
        const Estimate& estimate = fit.resonator.*parameter.member;
        if (estimate.given()) {
            const double u = estimate.uncertainty();
            budget.push_back(
                {parameter, estimate.value, estimate.sd, fit.shares[k], u, coverage_factor * u});
        }
    }
    return budget;
}

std::vector<ErrorSource> sources_of(std::span<const ParameterBudget> budget) {
    std::vector<ErrorSource> found;
    for (int k = 0; k < error_sources; ++k) {
        const auto source = static_cast<ErrorSource>(k);
        if (std::ranges::any_of(
                budget, [&](const ParameterBudget& row) { return row.shares[source] > 0; })) {
            found.push_back(source);
        }
    }
    return found;
}

}  // namespace vybeg
