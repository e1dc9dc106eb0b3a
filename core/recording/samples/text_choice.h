#pragma once

#include "core/base/describe.h"
#include "core/base/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vybeg {

// Options of a text file (--delimiter and its companions); other properties are guessed from its
// content.
struct TextChoice {
    std::optional<char> delimiter{};              // as in TextFormat
    std::optional<bool> decimal_comma{};          // otherwise a point
    std::optional<std::int64_t> lines_to_skip{};  // above the first row
    std::optional<int> time_column{};     // from 1, counting every column of the file; 0: none
    std::optional<double> time_unit_s{};  // seconds per unit of the time column

    friend bool operator==(const TextChoice&, const TextChoice&) = default;
};

template <class Archive, Described<TextChoice> Owner>
void describe(Archive&& archive, Owner& text) {
    archive("delimiter", text.delimiter);
    archive("decimal_comma", text.decimal_comma);
    archive("lines_to_skip", text.lines_to_skip);
    archive("time_column", text.time_column);
    archive("time_unit_s", text.time_unit_s);
}

// Limit of skipped lines: enough for a header, too few for a second table.
inline constexpr std::int64_t most_skipped_lines = 1'000'000;

// Checks the options without a file. Errors: setting_invalid.
Status check_choice(const TextChoice& choice);

// Delimiter of the names comma, semicolon, tab, space, bar; empty for other names.
std::optional<char> delimiter_from_name(std::string_view name);
std::string delimiter_name(char delimiter);

// Seconds of the names s, ms, us, ns; empty for other names.
std::optional<double> time_unit_from_name(std::string_view name);
std::string time_unit_name(double seconds);

}  // namespace vybeg
