#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Values of options as text, read without regard to the locale. `option` is the name on the command
// line, dashes included. Errors: setting_invalid with the option, the text and the allowed values.

Error refused_value(MessageArg option, MessageArg text, MessageArg allowed);

// A number, plain or with a unit after it that converts to `unit`: 25.4ms in s, 0.1deg in rad,
// 5kHz in Hz, 2% and 5ppm of a ratio (""). Nothing for any other text.
std::optional<double> number_with_unit(std::string_view text, std::string_view unit);

// A finite number, plain or with a unit after it, in `unit`; without one none may follow.
Result<double> read_number(const std::string& option, const std::string& text,
                           const std::string& unit = "none");
Result<std::int64_t> read_whole(const std::string& option, const std::string& text);
// Exactly `count` finite numbers with commas between them.
Result<std::vector<double>> read_numbers(const std::string& option, const std::string& text,
                                         std::size_t count, const std::string& allowed,
                                         const std::string& unit = "none");

}  // namespace vybeg
