#pragma once

#include "core/recording/samples/recording.h"
#include "core/recording/text/text_columns.h"

#include <cstddef>
#include <span>
#include <string>

namespace vybeg {

// The lines above a table.
struct LinesAbove {
    std::span<const std::string> lines{};
    std::size_t names_from = 0;  // lines above this one hold numbers, and do not name the columns
    // Fields of the table's rows.
    std::size_t longest = 0;     // of a row: the table's columns, or more
    std::size_t used = 0;        // but for columns at the end that are empty in all rows
    std::size_t named = 0;       // of these, but for columns at the end that hold words
    bool first_unnamed = false;  // the first one counts the rows, rises as a time or holds words
    bool first_is_time = false;  // it rises and counts no rows: no other one is the time
};

// Names, units and rates from the lines above the first row of numbers. Of names and units the last
// lines count: "t [s];S_C [V]", "C (V)", "# C, V", "Ch 1 Ch 2", without the first of them where
// that column may have none, or names and below them a line of units; for what these leave open,
// lines that say what they hold ("TraceName,C,D", "Vertical Units,V,V"). `format` has the
// delimiter, decimal sign and number of columns; it gets the headings, empty where unknown, of all
// fields that a row has, how many lines they took, whether they end with one that may have remarks
// below it, and the rates.
void read_header(const LinesAbove& above, TextFormat& format);

}  // namespace vybeg
