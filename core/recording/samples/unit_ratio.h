#pragma once

#include <optional>
#include <string_view>

namespace vybeg {

// Factor from the unit `from` to the unit `to`: 1e-3 from "mV" to "V", 1 from "Volt" to "В", 1 for
// equal texts. Empty for units of different quantities and for unknown units.
std::optional<double> unit_ratio(std::string_view from, std::string_view to);

// Whether the text is a unit with or without a prefix ("V", "мВ", "m/s").
bool is_known_unit(std::string_view text);

// The same for a word without brackets, which may be a name as well: "A" and "В" number channels.
bool is_unit_by_itself(std::string_view text);

}  // namespace vybeg
