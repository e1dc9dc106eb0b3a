#pragma once

#include "core/recording/samples/recording.h"
#include "core/recording/text/text_columns.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

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

// Names and units from the lines above the first row of numbers, of which the last ones count:
// "t [s];S_C [V]", "C (V)", "# C, V", "Ch 1 Ch 2", without the first of them where that column may
// have none, or names and below them a line of units; for what these leave
// open, lines that say what they hold ("TraceName,C,D", "Vertical Units,V,V"). `format` has the
// delimiter and number of columns; it gets the headings, empty where unknown, of all fields that a
// row has, how many lines they took, and whether they end with one that may have remarks below it.
void read_header(const LinesAbove& above, TextFormat& format);

// The rate of each column of the table by the fields and lines above it that name a rate or a step
// ("Sample Interval,2E-06", "# Samplerate: 10 kHz", "Delta_X", "Start,Increment" over their
// values, "dt=0.001"). Empty where there is none, or where two of them disagree by more than their
// digits.
std::vector<SampleRate> header_rates(std::span<const std::string> lines, char delimiter,
                                     int columns, bool decimal_comma);

// The unit of the times by a line that says so ("HUnit,ms", "Time markers scale: ms"); empty where
// no line names one of time.
std::string axis_unit(std::span<const std::string> lines, char delimiter);

}  // namespace vybeg
