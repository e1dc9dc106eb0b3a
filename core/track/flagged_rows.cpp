#include "core/track/flagged_rows.h"

#include <algorithm>

namespace vybeg {

void set_flags(std::span<Flags> part, std::size_t first, std::span<const FlaggedRows> flagged) {
    for (const FlaggedRows& rows : flagged) {
        const std::size_t end = std::min(rows.first + rows.count, first + part.size());
        for (std::size_t row = std::max(rows.first, first); row < end; ++row) {
            set(part[row - first], rows.flag);
        }
    }
}

}  // namespace vybeg
