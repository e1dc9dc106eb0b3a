#pragma once

#include "core/track/track.h"

#include <cstddef>
#include <span>

namespace vybeg {

// Consecutive rows of a track that get a flag after their estimation, because the reason is known
// only at the end of the recording.
struct FlaggedRows {
    std::size_t first = 0;
    std::size_t count = 0;
    Flag flag{};

    friend bool operator==(const FlaggedRows&, const FlaggedRows&) = default;
};

// Sets the flags of a part of the track that begins with its row `first`. Rows of other parts are
// ignored.
void set_flags(std::span<Flags> part, std::size_t first, std::span<const FlaggedRows> flagged);

}  // namespace vybeg
