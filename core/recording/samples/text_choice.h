#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vybeg {

// What the engineer says of a text file (--delimiter and its companions); the rest is guessed from
// its content.
struct TextChoice {
    std::optional<char> delimiter{};              // as in TextFormat
    std::optional<bool> decimal_comma{};          // else a point
    std::optional<std::int64_t> lines_to_skip{};  // above the first row
    std::optional<int> time_column{};  // from 1, every column of the file counts; 0: there is none
    std::optional<double> time_unit_s{};  // seconds per unit of the time column
    double scale = 1;                     // recording units per unit of the file

    friend bool operator==(const TextChoice&, const TextChoice&) = default;
};

// Lines that may be skipped: a header, and no second table.
inline constexpr std::int64_t most_skipped_lines = 1'000'000;

// The choice by itself. Errors: setting_invalid.
Status check_choice(const TextChoice& choice);

// What is said, as on the command line ("--delimiter semicolon --skip-lines 3"); empty where
// nothing is.
std::string choice_text(const TextChoice& choice);

// comma, semicolon, tab, space, bar; nothing for any other name.
std::optional<char> delimiter_from_name(std::string_view name);

// s, ms, us, ns as seconds; nothing for any other name.
std::optional<double> time_unit_from_name(std::string_view name);

}  // namespace vybeg
