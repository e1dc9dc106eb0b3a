#include "core/track/flagged_rows.h"

#include <algorithm>

namespace vybeg {

void set_flags(Track& part, std::size_t first, std::span<const FlaggedRows> flagged) {
    const std::span<Flags> flags = part.flags();
    for (const FlaggedRows& rows : flagged) {
        const std::size_t end = std::min(rows.first + rows.count, first + flags.size());
        for (std::size_t row = std::max(rows.first, first); row < end; ++row) {
            set(flags[row - first], rows.flag);
        }
    }
}

}  // namespace vybeg
