#pragma once

#include "core/base/result.h"
#include "core/output/output_file.h"
#include "core/track/track.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// The columns of numbers in a track's file, in their order: t_s, the slow variables, standard
// deviations. The flags come last.
inline constexpr std::size_t track_number_columns = 13;
inline constexpr const char* flag_column_name = "flag";
// The array of the header's lines, in the formats other than CSV.
inline constexpr const char* header_name = "header";

// With the unit at its end, e.g. "two_theta_A_rad".
std::string track_column_name(std::size_t column);
std::string track_column_unit(std::size_t column);  // empty: the recording's
std::span<const double> track_column(const Track& track, std::size_t column);
std::span<double> track_column(Track& track, std::size_t column);

// The rows of a track: for the formats that keep one array per column each column by itself, from
// its first row on, as often as the format needs it; for CSV whole rows.
class TrackColumns {
public:
    using NumberSink = std::function<Status(std::span<const double> rows)>;
    using FlagSink = std::function<Status(std::span<const Flags> rows)>;

    TrackColumns() = default;
    TrackColumns(const TrackColumns&) = delete;
    TrackColumns& operator=(const TrackColumns&) = delete;
    virtual ~TrackColumns() = default;

    virtual std::size_t rows() const = 0;
    // Passes a column, some thousand rows at a time. Errors: those of the sink and of the place
    // where the rows lie.
    virtual Status numbers(std::size_t column, const NumberSink& sink) const = 0;
    virtual Status flags(const FlagSink& sink) const = 0;
    // Passes whole rows, about so many at a time where they do not lie in memory.
    virtual Status whole_rows(std::size_t at_once, const TrackSink& sink) const = 0;
};

// Those of a track in memory, which must outlive it.
class MemoryColumns final : public TrackColumns {
public:
    explicit MemoryColumns(const Track& track) : track_(track) {}

    std::size_t rows() const override { return track_.rows(); }
    Status numbers(std::size_t column, const NumberSink& sink) const override;
    Status flags(const FlagSink& sink) const override;
    Status whole_rows(std::size_t, const TrackSink& sink) const override { return sink(track_); }

private:
    const Track& track_;
};

// The rows of a track from their computation until its header is known, because the last warnings
// come with the last window: a few MiB in memory, the rest in an unnamed file in
// output.spool_folder(), which the system removes in any case. Every write checks the stop token.
// Not for two threads at once. Errors: output_failed, interrupted.
class TrackSpool final : public TrackColumns {
public:
    // `output` must outlive it.
    TrackSpool(const OutputFile& output, const JobControl& job) : output_(output), job_(job) {}

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
        std::int64_t place = 0;  // of its bytes: column after column, then the flags

        std::int64_t place_of(std::size_t column) const {
            return place + static_cast<std::int64_t>(column * rows * sizeof(double));
        }
    };
    Status write(std::span<const std::byte> bytes);
    Status write_out(std::string_view bytes);
    Status create_file();
    Status read(std::int64_t from, std::span<std::byte> to) const;
    Error failed(int error) const { return output_.failure(system_reason(error)); }
    Status read_flags(const Block& block, std::span<Flags> flags) const;

    const OutputFile& output_;
    JobControl job_;
    Descriptor file_;
    std::int64_t spilled_ = 0;  // bytes in the file
    std::string memory_;        // those after them
    std::vector<Block> blocks_;
    std::size_t rows_ = 0;
    std::vector<FlaggedRows> flagged_;
};

}  // namespace vybeg
