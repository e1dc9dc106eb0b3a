#pragma once

#include "core/output/output_file.h"
#include "core/output/track_columns.h"

#include <cstddef>
#include <functional>
#include <map>
#include <string>

namespace vybeg {

// The combinations of flags that a track has, each with the number of its rows. There are few, so
// that every format makes their texts once. Errors: those of TrackColumns.
using FlagCounts = std::map<Flags, std::size_t>;
Result<FlagCounts> count_flags(const TrackColumns& columns);

// The longest of their texts, at least 1: no format has texts without any room.
std::size_t longest_text(const FlagCounts& counts);

// What each combination looks like in a file.
using FlagCells = std::map<Flags, std::string>;
FlagCells make_cells(const FlagCounts& counts,
                     const std::function<std::string(const std::string& text)>& cell);

// Passes the cells of all rows, many at a time. Errors: those of the sink and of TrackColumns.
Status pass_cells(const TrackColumns& columns, const FlagCells& cells,
                  const std::function<Status(std::string_view bytes)>& sink);

}  // namespace vybeg
