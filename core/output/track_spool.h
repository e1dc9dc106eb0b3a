#pragma once

#include "core/output/spool.h"
#include "core/output/track_columns.h"
#include "core/track/track.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace vybeg {

// The rows of a track from their computation until its header is known, because the last warnings
// come with the last window. Not for two threads at once. Errors: those of Spool.
class TrackSpool final : public TrackColumns {
public:
    // `file` must outlive it.
    TrackSpool(const OutputFile& file, const JobControl& job) : spool_(file, job) {}

    Status append(const Track& rows);
    // Rows that get a flag while they are read.
    void set_flagged(std::span<const FlaggedRows> flagged) {
        flagged_.assign(flagged.begin(), flagged.end());
    }

    std::size_t rows() const override { return rows_; }
    Status numbers(std::size_t column, const NumberSink& sink) const override;
    Status flags(const FlagSink& sink) const override;
    // Passes whole rows, about so many at a time.
    Status whole_rows(std::size_t at_once, const TrackSink& sink) const;

private:
    struct Block {  // of one append()
        std::size_t first = 0;
        std::size_t rows = 0;
        std::int64_t place = 0;  // in the spool: column behind column, then the flags

        std::int64_t place_of(std::size_t column) const {
            return place + static_cast<std::int64_t>(column * rows * sizeof(double));
        }
    };
    Status read_flags(const Block& block, std::span<Flags> flags) const;
    Status read_block(const Block& block, Track& rows) const;

    Spool spool_;
    std::vector<Block> blocks_;
    std::size_t rows_ = 0;
    std::int64_t bytes_ = 0;
    std::vector<FlaggedRows> flagged_;
};

}  // namespace vybeg
