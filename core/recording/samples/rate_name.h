#pragma once

#include <optional>
#include <string_view>

namespace vybeg {

// Sample rate (Hz) from a named number of a file: the number itself for the names fs, rate,
// sample_rate, ...; its inverse for dt, wf_increment, ... Upper and lower case and underscores do
// not matter. `unit` is that of the number ("kHz", "ms"), empty: Hz or s. Empty for other names,
// unsuitable units and rates that are not positive.
std::optional<double> rate_by_name(std::string_view name, double value, std::string_view unit = {});

// Hertz per unit of a rate: 1000 of "kHz" and "kS/s". Empty for other units.
std::optional<double> hertz_per(std::string_view unit);

// Part after the last '.' or '/' of a path: "C" of "run.C" or "/run/C".
std::string_view last_name(std::string_view path);

}  // namespace vybeg
