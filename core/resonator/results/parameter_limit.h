#pragma once

#include "core/resonator/model/reason.h"
#include "core/resonator/results/resonator_parameters.h"

#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// What a resonator's parameter has to keep, in its unit of resonator_parameters.h; ends included.
struct ParameterLimit {
    std::string parameter;  // its name there; of no axis, which has no least or greatest value
    std::optional<double> lower;
    std::optional<double> upper;

    friend bool operator==(const ParameterLimit&, const ParameterLimit&) = default;
};

// unknown: the parameter has no value, or its coverage interval reaches over a limit.
enum class Conformity { unknown, within, outside };

// Whether the whole coverage interval lies on one side of the limits: guarded acceptance and
// guarded rejection with guard bands U = 2u, JCGM 106:2012, 8.3.2 and 8.3.3. unknown, too, for a
// value without an uncertainty.
Conformity conformity(const Estimate& estimate, const ParameterLimit& limit);

// Whether a resonator keeps all of its limits.
struct LimitVerdict {
    std::optional<Conformity> conformity;  // outside where one parameter is; none: it has no limits
    std::vector<std::string> failed;       // parameters that are not shown to be within
};
LimitVerdict keeps_limits(const ResonatorEstimate& resonator,
                          const std::vector<ParameterLimit>& limits);

// Of this parameter; nullptr: none.
const ParameterLimit* limit_of(const std::vector<ParameterLimit>& limits, const char* parameter);

// The parameters that can have limits.
std::vector<ResonatorParameter> limited_parameters();

}  // namespace vybeg
