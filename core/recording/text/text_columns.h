#pragma once

#include "core/recording/samples/recording.h"
#include "core/recording/samples/text_choice.h"
#include "core/recording/text/text_layout.h"

#include <span>
#include <string>
#include <vector>

namespace vybeg {

// More are no channels: the samples stand in rows.
inline constexpr int most_columns = 4096;

// Finds what the columns of a table are: its time, the columns that belong to no channel, and the
// times of channels that have their own. `rows` are the first lines of the table, `columns` its
// names and units; `format` has the delimiter, decimal sign, number of columns and rates, and what
// `choice` says is taken as said. `words`: columns, from 0 and rising, that hold words; those of
// them that hold some below the names are no channels.
//
// Time is a column that is named so or holds times of day, or else the first of three or more if
// it rises evenly and counts in no other unit than one of time. As long as two channels are left, a
// column is none that is empty, a date, whole numbers that rise by one, or a time again.
void find_columns(std::span<const std::string> rows, const std::vector<Channel>& columns,
                  const TextChoice& choice, std::vector<int> words, TextFormat& format);

}  // namespace vybeg
