#pragma once

#include "core/analysis/measurement_list.h"

#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// Conditions of a set as a whole in a measurement list, for tables, passports and databases.

// The first gyro that a recording of the set names, and the first date, ISO 8601; empty: none.
std::string gyro_of(const MeasurementSet& set);
std::string list_date_of(const MeasurementSet& set);

// The conditions of a recording as a list has them, column by column; empty: not told.
std::vector<std::pair<std::string, std::string>> fields_of(const Conditions& conditions);

// bias_v, temperature_c, exchanged, operator, comment: columns of a list, and their fields. Fields
// of recordings that differ stand side by side with ";" between; empty: not told.
std::vector<std::pair<std::string, std::string>> conditions_of(const MeasurementSet& set);

// The fields of the k-th unknown column in the same way.
std::string other_of(const MeasurementSet& set, std::size_t k);

}  // namespace vybeg
