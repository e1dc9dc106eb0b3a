#pragma once

#include "core/recording/samples/recording.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// What the lines above the numbers call the columns.
struct TextHeader {
    std::vector<Channel> columns;  // also those behind; empty names and units where unknown
    int lines_used = 0;            // how many lines that took
    bool has_remarks = false;      // the names end with one that may have remarks below it
};

// The lines above a table of so many columns.
struct LinesAbove {
    std::span<const std::string> lines;
    std::size_t names_from = 0;  // lines above this one hold numbers, and do not name the columns
    char delimiter = ',';
    std::size_t columns = 0;
    std::size_t behind = 0;      // more columns that some rows have
    std::size_t used = 0;        // columns but for those at the end that are empty in all rows
    std::size_t named = 0;       // of these, but for those at the end that hold words
    bool first_unnamed = false;  // the first one counts the rows, rises as a time or holds words
    bool first_is_time = false;  // it rises and counts no rows: no other one is the time
};

// Names and units from the lines above the first row of numbers, of which the last ones count:
// "t [s];S_C [V]", "C (V)", "# C, V", "Ch 1 Ch 2", without the first of them where that column may
// have none, or names and below them a line of units; for what these leave
// open, lines that say what they hold ("TraceName,C,D", "Vertical Units,V,V").
TextHeader read_header(const LinesAbove& above);

}  // namespace vybeg
