#include "core/track/flagged_rows.h"

#include <algorithm>

namespace vybeg {

void set_flags(Track& track, std::span<const FlaggedRows> flagged) {
    const std::span<Flags> flags = track.flags();
    for (const FlaggedRows& rows : flagged) {
        const std::size_t end = std::min(rows.first + rows.count, flags.size());
        for (std::size_t row = rows.first; row < end; ++row) {
            set(flags[row], rows.flag);
        }
    }
}

}  // namespace vybeg
