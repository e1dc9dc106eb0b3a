#pragma once

#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// How a text file writes its table of numbers: what find_table() needs, guessed or
// chosen in a dialog.
struct TextFormat {
    char delimiter = ',';  // ',' ';' '\t' '|' or ' ', which means any blanks
    bool decimal_comma = false;
    std::int64_t lines_to_skip = 0;    // lines above the first row of numbers
    std::vector<std::string> above{};  // what the lines above it begin with
    int columns = 0;
    int time_column = -1;        // from 0; -1: none
    int counter_column = -1;     // from 0: numbers of the rows, neither time nor channel; -1: none
    double time_unit_s = 1;      // seconds per unit of the time column
    double own_time_unit_s = 1;  // of other time columns, where they name none
    int header_lines_used = 0;   // of the skipped lines, those that the names and units came from
    std::vector<Channel> headings;     // of each column, empty where the file has none
    std::vector<int> no_channels{};    // columns beside these that hold no samples, from 0
    std::vector<std::string> words{};  // names, or else numbers from 1, of columns that hold words
    std::vector<int> own_times{};      // the time column of each column, where they are not all one
    std::optional<std::int64_t> clock_from_s{};  // times of day count from this second of the day
    std::vector<SampleRate> rates{};  // of each column; empty where the lines above name none
    bool has_remarks = false;         // text after the last column is a comment
    std::string unknown_time_unit{};  // of the time column, which is read as seconds

    const Channel& heading(int column) const { return headings[static_cast<std::size_t>(column)]; }

    friend bool operator==(const TextFormat&, const TextFormat&) = default;
};

// Whether a column is one, from 0: all are but the time, the counter and no_channels.
bool is_channel(const TextFormat& format, int column);
std::vector<int> channel_columns(const TextFormat& format);

// The kind of the first column of a table by its numbers; the rows that it counts, and the time
// that rises evenly, need no name.
enum class FirstColumn : std::uint8_t { other, counter, time };
FirstColumn first_column(std::span<const std::string> rows, char delimiter, bool decimal_comma);

// Whether a line at the end of a file is below its table: a comment, or one that begins with a
// word where the rows begin with a number ("Total;12,5;3,1", "End of data").
bool is_behind_table(std::string_view line, const TextFormat& format);

// More are no channels: the file has the samples of a channel in a row.
inline constexpr int most_columns = 4096;

// Finds what the columns of a table are: its time, the columns that belong to no channel, and the
// times of channels that have their own. `rows` are the first lines of the table; `format` has the
// delimiter, decimal sign, number and headings of the columns and rates, and what `choice` says is
// taken as said. `words`: columns, from 0 and rising, that hold words; those of
// them that hold some below the names are no channels.
//
// Time is a column that is named so or holds times of day, or else the first of three or more if
// it rises evenly and counts in no other unit than one of time. As long as two channels are left, a
// column is none that is empty, a date, whole numbers that rise by one, or a time again.
void find_columns(std::span<const std::string> rows, const TextChoice& choice,
                  std::vector<int> words, TextFormat& format);

}  // namespace vybeg
