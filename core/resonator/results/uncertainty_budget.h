#pragma once

#include "core/resonator/results/resonator_parameters.h"

#include <span>
#include <vector>

namespace vybeg {

// Coverage factor of an expanded uncertainty: about 95 % of a normal distribution (GUM 6.2).
inline constexpr double coverage_factor = 2;

// Uncertainty budget of a given parameter (GUM, JCGM 100:2008, 5.1.2): standard uncertainties in
// the parameter's unit.
struct ParameterBudget {
    ResonatorParameter parameter;
    double value = 0;
    double statistical = 0;  // of the noise, type A
    BySource shares{};       // of the tolerances, type B
    double combined = 0;     // u: root of the sum of all squares
    double expanded = 0;     // coverage_factor u
};

// Of the parameters that are given, in the order of resonator_parameters; empty for the free model.
std::vector<ParameterBudget> uncertainty_budget(const ResonatorFit& fit);

// The sources that contribute to any of the parameters.
std::vector<ErrorSource> sources_of(std::span<const ParameterBudget> budget);

}  // namespace vybeg
