#pragma once

#include "core/database/stored_result.h"

#include <cstdint>
#include <string>

namespace vybeg {

// One result in the history of a parameter.
struct HistoryPoint {
    std::int64_t id = 0;  // of ResultsDatabase::result()
    std::string set;
    std::string gyro;
    StoredDate date;
    double time_s = 0;   // of the date, iso_seconds(); NaN: there is none
    Estimate f_mean_hz;  // mean frequency, which follows the temperature
    Estimate value;      // without one: NaN with the reason
    // Of the recordings that tell them; NaN: none does. The temperature is their mean.
    double bias_v = 0;
    double temperature_c = 0;
    bool exchanged = false;
    std::string program;
    std::string warnings;  // warning_kinds() of the result
};

}  // namespace vybeg
