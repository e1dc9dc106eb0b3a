#pragma once

#include "core/analysis/measurement_list.h"

#include <string>

namespace vybeg {

// One set of a batch, on its way to its row.
struct SetTask {
    const MeasurementSet* set = nullptr;
    std::string passport;  // file that it is compared with; empty: none
    std::string json;      // file of the result; empty: none
    std::string key;       // of its row
};

}  // namespace vybeg
