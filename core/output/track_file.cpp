#include "core/output/track_file.h"

#include "core/base/number_text.h"
#include "core/output/output_paths.h"
#include "core/output/track_arrays.h"
#include "core/output/track_header.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

namespace vybeg {
namespace {

// Rows that one task writes as text, a quarter of a megabyte.
constexpr std::size_t rows_per_block = 1024;
// Blocks converted to text in parallel and then written, some megabytes.
constexpr std::size_t blocks_at_once = 32;

std::string head_text(std::span<const std::string> header) {
    std::string text;
    for (const std::string& line : header) {
        text += "# " + line + "\n";
    }
    for (std::size_t column = 0; column < track_number_columns; ++column) {
        text += track_column_name(column) + ",";
    }
    return text + flag_column_name + "\n";
}

// Upper limit of the length of a row.
constexpr std::size_t longest_row =
    track_number_columns * (longest_round_trip + 1) + longest_flags_text + 1;

using Columns = std::array<std::span<const double>, track_number_columns>;

Columns columns_of(const Track& track) {
    Columns columns;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        columns[k] = track_column(track, k);
    }
    return columns;
}

char* write_row(char* to, const Columns& columns, Flags flags, std::size_t row) {
    for (const std::span<const double> column : columns) {
        to = write_round_trip(to, column[row]);
        *to++ = ',';
    }
    if (flags != 0) {
        to = std::ranges::copy(flags_text(flags), to).out;
    }
    *to++ = '\n';
    return to;
}

// Text of some rows, in memory that is allocated once and never cleared.
class RowsText {
public:
    std::string_view write(const Track& track, std::size_t first, std::size_t end) {
        if (!room_) {
            room_.reset(new char[rows_per_block * longest_row]);
        }
        const Columns columns = columns_of(track);
        char* to = room_.get();
        for (std::size_t row = first; row < end; ++row) {
            to = write_row(to, columns, track.flags()[row], row);
        }
        return {room_.get(), static_cast<std::size_t>(to - room_.get())};
    }

private:
    std::unique_ptr<char[]> room_;
};

// Passes the rows to write(text, rows so far), some at a time. All threads convert digits, because
// these take most of the time of a track.
template <class Write>
Status write_rows(const Track& track, Write write) {
    const std::size_t blocks = (track.rows() + rows_per_block - 1) / rows_per_block;
    const std::size_t at_once = std::min(blocks, blocks_at_once);
    std::vector<RowsText> texts(at_once);
    std::vector<std::string_view> written(at_once);
    const auto end_of = [&](std::size_t block) {
        return std::min((block + 1) * rows_per_block, track.rows());
    };
    for (std::size_t first = 0; first < blocks; first += at_once) {
        const std::size_t count = std::min(at_once, blocks - first);
        // Isolated: a thread that waits here must not begin to estimate or to read.
        tbb::this_task_arena::isolate([&] {
            tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
                written[k] = texts[k].write(track, (first + k) * rows_per_block, end_of(first + k));
            });
        });
        for (std::size_t k = 0; k < count; ++k) {
            TRY(write(written[k], end_of(first + k)));
        }
    }
    return {};
}

Status write_track_csv(OutputFile& file, const TrackColumns& columns,
                       std::span<const std::string> header, const JobControl& job) {
    TRY(file.write(head_text(header)));
    std::size_t before = 0;
    return columns.whole_rows(rows_per_block * blocks_at_once, [&](const Track& track) {
        const Status written = write_rows(track, [&](std::string_view text, std::size_t done) {
            job.report(static_cast<double>(before + done) / static_cast<double>(columns.rows()));
            return file.write(text);
        });
        before += track.rows();
        return written;
    });
}

}  // namespace

Result<TrackFormat> track_format(const std::filesystem::path& target) {
    const std::string ending = file_ending(target);
    if (ending == ".npy") {
        return Error{ErrorCode::output_failed,
                     target.string(),
                     {words(VYBEG_MESSAGE("Words",
                                          "a NumPy file has room for one array only; let its name "
                                          "end in .npz"))}};
    }
    TRY(check_ending(target, {"", ".csv", ".txt", ".mat", ".h5", ".hdf5", ".npz"}));
    return ending == ".mat"                       ? TrackFormat::mat
           : ending == ".h5" || ending == ".hdf5" ? TrackFormat::hdf5
           : ending == ".npz"                     ? TrackFormat::npz
                                                  : TrackFormat::csv;
}

Status write_track(OutputFile& file, TrackFormat format, const TrackColumns& columns,
                   std::span<const std::string> header, const JobControl& job) {
    const std::vector<std::string> lines = single_lines(header);
    switch (format) {
        case TrackFormat::csv: return write_track_csv(file, columns, lines, job);
        case TrackFormat::mat: return write_track_mat(file, columns, lines);
        case TrackFormat::hdf5: return write_track_hdf5(file, columns, lines);
        case TrackFormat::npz: break;
    }
    return write_track_npz(file, columns, lines);
}

Status write_track(OutputFile& file, TrackFormat format, const Track& track,
                   std::span<const std::string> header, const JobControl& job) {
    return write_track(file, format, MemoryColumns(track), header, job);
}

}  // namespace vybeg
