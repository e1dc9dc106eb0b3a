#pragma once

#include "core/recording/recording.h"
#include "core/recording/text_choice.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// How a text file writes its table of numbers: what find_table() needs to know, whether it was
// guessed or said in a dialog.
struct TextFormat {
    char delimiter = ',';  // ',' ';' '\t' '|' or ' ', which stands for any blanks
    bool decimal_comma = false;
    std::int64_t lines_to_skip = 0;  // lines above the first row of numbers
    int columns = 0;
    int time_column = -1;       // from 0; -1: none
    int counter_column = -1;    // from 0: numbers of the rows, neither time nor channel; -1: none
    double time_unit_s = 1;     // seconds per unit of the time column
    int header_lines_used = 0;  // of the skipped lines, those that the names and units came from
    std::vector<std::string> names;  // one per column, empty where the file does not tell
    std::vector<std::string> units;

    friend bool operator==(const TextFormat&, const TextFormat&) = default;
};

// Guesses the format from the first lines of a file: the separator and decimal sign under which
// most of them are rows of numbers of the same length, at least two. Nothing where there is no such
// row. Time is a column that is named so, or else the first of three or more if it rises evenly; a
// column of whole numbers without a unit and with no name, or one like "n", counts rows and is
// neither time nor channel. What `choice` says is taken as said; its time column counts where the
// table has it.
std::optional<TextFormat> guess_text_format(std::span<const std::string> lines,
                                            const TextChoice& choice = {});

// The columns that are channels, from 0: all but the time and the counter.
std::vector<int> channel_columns(const TextFormat& format);

// Their names, numbers from 1 where the file has none, and units: the file's where the samples are
// read as they stand there, with a scale of 1, else none.
std::vector<Channel> channels_of(const TextFormat& format, double scale);

// E.g. "text, 3 columns, semicolon, decimal comma".
std::string format_text(const TextFormat& format);

}  // namespace vybeg
