#pragma once

#include "core/recording/samples/recording.h"
#include "core/recording/samples/recording_format.h"
#include "core/recording/samples/text_choice.h"
#include "core/recording/text/text_columns.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// Guesses the format from the first lines of a file: the separator and decimal sign under which
// most of them are rows of numbers of the same length, at least two. Nothing where there is no such
// row. Time, and what is no channel, as find_columns() has it. What `choice` says is taken as said;
// its time column counts where the table has it.
std::optional<TextFormat> guess_text_format(std::span<const std::string> lines,
                                            const TextChoice& choice = {});

// The channels of the file by name, numbers from 1 where it has none, and unit.
std::vector<Channel> channels_of(const TextFormat& format);

// Whether commas separate both columns and decimals: "0,000030,1,234500,0,678900". Integers have no
// leading zeros, decimals between delimiters have.
bool has_decimal_commas(std::span<const std::string> lines, const TextFormat& format);

// E.g. "text, 3 columns, semicolon, decimal comma".
RecordingFormat format_of(const TextFormat& format);

}  // namespace vybeg
