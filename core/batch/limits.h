#pragma once

#include "core/analysis/passport.h"
#include "core/base/result.h"
#include "core/resonator/results/resonator_parameters.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// A row of a table of limits.
struct TypedLimit {
    std::string gyro_type;  // empty: of every gyro whose type has no limit of its own
    ParameterLimit limit;
};

// Reads a table of limits, CSV as a measurement list is one: parameter, least, greatest, gyro_type
// (may be missing). Parameters are named as in the table of results; an empty field is no limit.
// Errors: those of read_csv(); list_invalid.
Result<std::vector<TypedLimit>> read_limits(const std::filesystem::path& path);

// The limits of one type of gyro, those of its own in place of those of all.
std::vector<ParameterLimit> limits_of_type(const std::vector<TypedLimit>& limits,
                                           const std::string& gyro_type);

// Reads NAME=X[,NAME=X]: parameters named as in the table of results, whose unit may be left out
// (tau, f_mean). X is in the parameter's unit or, as X% or Xppm, relative to the passport's value.
// Errors: setting_invalid of --limit.
Result<std::vector<PracticalLimit>> read_practical_limits(std::string_view text);

// The text that reads back as these limits.
std::string practical_limits_text(const std::vector<PracticalLimit>& limits);

}  // namespace vybeg
