#pragma once

#include "core/analysis/measurement_list.h"
#include "core/resonator/results/parameter_limit.h"

#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// One set of a batch, on its way to its row.
struct SetTask {
    const MeasurementSet* set = nullptr;
    std::string passport;      // file that it is compared with; empty: none
    std::string json;          // file of the result; empty: none
    std::string new_passport;  // file of the set's own passport; empty: none
    std::optional<std::vector<ParameterLimit>> limits;  // none: the table has no limits
    std::string key;                                    // of its row
};

}  // namespace vybeg
