#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vybeg {

// Values of options as text, read without regard to the locale. `option` is the name on the command
// line, dashes included. Errors: setting_invalid with the option, the text and what is allowed.

Error refused_value(const std::string& option, const std::string& text, const std::string& allowed);

// A finite number.
Result<double> read_number(const std::string& option, const std::string& text);
Result<std::int64_t> read_whole(const std::string& option, const std::string& text);
// Exactly `count` finite numbers with commas between them.
Result<std::vector<double>> read_numbers(const std::string& option, const std::string& text,
                                         std::size_t count, const std::string& allowed);

}  // namespace vybeg
