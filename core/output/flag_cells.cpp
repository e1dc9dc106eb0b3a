#include "core/output/flag_cells.h"

#include <algorithm>

namespace vybeg {

Result<FlagCounts> count_flags(const TrackColumns& columns) {
    FlagCounts counts;
    TRY(columns.flags([&counts](std::span<const Flags> rows) -> Status {
        // Neighbours have the same flags more often than not.
        for (auto at = rows.begin(); at != rows.end();) {
            const auto other = std::find_if(at, rows.end(), [&](Flags f) { return f != *at; });
            counts[*at] += static_cast<std::size_t>(other - at);
            at = other;
        }
        return {};
    }));
    return counts;
}

std::size_t longest_text(const FlagCounts& counts) {
    std::size_t longest = 1;
    for (const auto& [flags, rows] : counts) {
        longest = std::max(longest, flags_text(flags).size());
    }
    return longest;
}

FlagCells make_cells(const FlagCounts& counts,
                     const std::function<std::string(const std::string&)>& cell) {
    FlagCells cells;
    for (const auto& [flags, rows] : counts) {
        cells[flags] = cell(flags_text(flags));
    }
    return cells;
}

Status pass_cells(const TrackColumns& columns, const FlagCells& cells,
                  const std::function<Status(std::string_view)>& sink) {
    std::string bytes;
    return columns.flags([&](std::span<const Flags> rows) {
        bytes.clear();
        auto cell = cells.begin();
        for (const Flags flags : rows) {
            cell = cell->first == flags ? cell : cells.find(flags);
            bytes += cell->second;
        }
        return sink(bytes);
    });
}

}  // namespace vybeg
