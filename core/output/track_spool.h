#pragma once

#include "core/output/output_file.h"
#include "core/output/track_columns.h"
#include "core/track/track.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Bytes stored until the preceding part of an output is known: a few MiB in memory, the rest in an
// unnamed file, which the system removes in any case. Every write checks the stop token. Errors:
// output_failed, interrupted.
class Spool {
public:
    // Spool for `output`, which must outlive it, with its file in output.spool_folder().
    Spool(const OutputFile& output, const JobControl& job) : output_(output), job_(job) {}
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;
    ~Spool();

    Status write(std::span<const std::byte> bytes);

    // Reads bytes from the position `from` on. Preconditions: as many were written; no more writes.
    Status read(std::int64_t from, std::span<std::byte> to) const;

private:
    Status spill();
    Status write_out(std::string_view bytes);
    Status create();
    Error failed(int error) const;

    const OutputFile& output_;
    JobControl job_;
    std::string memory_;
    int descriptor_ = -1;
    std::int64_t spilled_ = 0;  // bytes
};

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
    Status whole_rows(std::size_t at_once, const TrackSink& sink) const override;

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
