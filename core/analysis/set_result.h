#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/measurement_list.h"
#include "core/analysis/passport.h"

#include <optional>
#include <string>

namespace vybeg {

// A set and the resonator found behind its recordings.
struct SetResult {
    std::string program;  // name and version of the one that identified it
    MeasurementSet set;   // its recordings with what they contain, as identification.runs
    Identification identification;
    std::optional<PassportComparison> comparison;
};

}  // namespace vybeg
