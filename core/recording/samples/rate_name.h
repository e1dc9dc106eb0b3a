#pragma once

#include <optional>
#include <string_view>

namespace vybeg {

// The sample rate (Hz) that a single number of a file means by its name: the number itself where it
// is called fs, rate, sample_rate, ...; its inverse where it is called dt, wf_increment, ...
// Upper and lower case and underscores do not matter. `unit` is that of the number ("kHz", "ms"),
// empty: Hz or s. Nothing where the name means no rate, the unit is none of its kind or the rate
// would not be a positive number.
std::optional<double> rate_by_name(std::string_view name, double value, std::string_view unit = {});

// Hertz per unit of a rate: 1000 of "kHz" and "kS/s". Nothing where it is none.
std::optional<double> hertz_per(std::string_view unit);

// What follows the last '.' or '/' of a path: "C" of "run.C" or "/run/C".
std::string_view last_name(std::string_view path);

}  // namespace vybeg
