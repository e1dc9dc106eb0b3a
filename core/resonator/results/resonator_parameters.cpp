#include "core/resonator/results/resonator_parameters.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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

double greatest_of(const Estimate& size) {
    if (size.reason.code != ReasonCode::within_noise || size.reason.args.empty()) {
        return std::nan("");
    }
    constexpr double half_a_digit = 5e-3;  // the reason has three digits
    return parse_number(size.reason.args.front().text).value_or(std::nan("")) * (1 + half_a_digit);
}

Conformity conformity(const Estimate& estimate, const ParameterLimit& limit) {
    const double half = coverage_factor * estimate.uncertainty();
    const double bound = greatest_of(estimate);
    const double least = estimate.given() ? estimate.value - half : 0;
    const double most = estimate.given() ? estimate.value + half : bound;
    if (!(least <= most)) {
        return Conformity::unknown;
    }
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

LimitVerdict keeps_limits(const ResonatorEstimate& resonator,
                          const std::vector<ParameterLimit>& limits) {
    LimitVerdict verdict;
    if (!limits.empty()) {
        verdict.conformity = Conformity::within;
    }
    for (const ResonatorParameter& parameter : resonator_parameters) {
        const ParameterLimit* const limit = limit_of(limits, parameter.name);
        if (limit == nullptr) {
            continue;
        }
        const Conformity one = conformity(resonator.*parameter.member, *limit);
        if (one != Conformity::within) {
            verdict.failed.emplace_back(parameter.name);
            const bool outside =
                one == Conformity::outside || verdict.conformity == Conformity::outside;
            verdict.conformity = outside ? Conformity::outside : Conformity::unknown;
        }
    }
    return verdict;
}

std::vector<ResonatorParameter> limited_parameters() {
    std::vector<ResonatorParameter> limited;
    limited.reserve(resonator_parameters.size());
    std::ranges::copy_if(resonator_parameters, std::back_inserter(limited),
                         [](const ResonatorParameter& each) { return each.period == 0; });
    return limited;
}

}  // namespace vybeg
