#include "core/output/track_csv.h"

#include "core/base/messages.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string_view>

namespace vybeg {
namespace {

constexpr std::array value_columns{
    SlowVariable::a_A, SlowVariable::a_B,          SlowVariable::two_theta_A, SlowVariable::alpha,
    SlowVariable::f,   SlowVariable::delta_phi_CD, SlowVariable::rms};
constexpr std::array sd_columns{SlowVariable::a_A, SlowVariable::a_B, SlowVariable::two_theta_A,
                                SlowVariable::alpha, SlowVariable::f};

// Rows that one task writes as text, a quarter of a megabyte.
constexpr std::size_t rows_per_block = 1024;
// Blocks converted to text in parallel and then written, some megabytes.
constexpr std::size_t blocks_at_once = 32;

// A file name may contain a line feed, a header line may not.
std::string one_line(std::string text) {
    for (char& character : text) {
        if (static_cast<unsigned char>(character) < ' ') {
            character = ' ';
        }
    }
    return text;
}

std::string column_names() {
    std::string names = "t_s";
    for (const SlowVariable variable : value_columns) {
        names += std::string(",") + info(variable).column;
    }
    for (const SlowVariable variable : sd_columns) {
        names += std::string(",sd_") + info(variable).column;
    }
    return names + ",flag\n";
}

std::string head_text(std::span<const std::string> header) {
    std::string text;
    for (const std::string& line : header) {
        text += "# " + one_line(line) + "\n";
    }
    return text + column_names();
}

// Upper limit of the length of a row.
constexpr std::size_t longest_row =
    (1 + value_columns.size() + sd_columns.size()) * (longest_round_trip + 1) + longest_flags_text +
    1;

char* write_row(char* to, const Track& track, std::size_t row) {
    to = write_round_trip(to, track.time_s()[row]);
    for (const SlowVariable variable : value_columns) {
        *to++ = ',';
        to = write_round_trip(to, track.values(variable)[row]);
    }
    for (const SlowVariable variable : sd_columns) {
        *to++ = ',';
        to = write_round_trip(to, track.sds(variable)[row]);
    }
    *to++ = ',';
    if (track.flags()[row] != 0) {
        to = std::ranges::copy(flags_text(track.flags()[row]), to).out;
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
        char* to = room_.get();
        for (std::size_t row = first; row < end; ++row) {
            to = write_row(to, track, row);
        }
        return {room_.get(), static_cast<std::size_t>(to - room_.get())};
    }

private:
    std::unique_ptr<char[]> room_;
};

// Visits the columns of the file until one fails.
template <class AnyTrack, class Visit>
Status for_each_column(AnyTrack& track, const Visit& visit) {
    Status done = visit(track.time_s());
    for (const SlowVariable variable : value_columns) {
        done = done ? visit(track.values(variable)) : done;
    }
    for (const SlowVariable variable : sd_columns) {
        done = done ? visit(track.sds(variable)) : done;
    }
    return done ? visit(track.flags()) : done;
}

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
            if (const Status taken = write(written[k], end_of(first + k)); !taken) {
                return taken;
            }
        }
    }
    return {};
}

}  // namespace

std::vector<std::string> track_header(const std::string& program, const Recording& recording,
                                      const std::string& sha256, const AnalysisSummary& analysis) {
    std::vector<std::string> lines{
        program,
        "input: " + plain_text(recording.path.filename().string()),
        "sha256: " + sha256,
        "rate: " + round_trip_text(recording.rate_hz) + " (" +
            rate_origin_name(recording.rate_from) + ")",
        "channels: " + integer_text(recording.channel_c) + "," + integer_text(recording.channel_d),
    };
    if (recording.rate_relative_sd > 0) {
        lines.push_back("rate_relative_sd: " + short_text(recording.rate_relative_sd, 3));
    }
    if (!recording.read_with.empty()) {
        lines.push_back("read with: " + recording.read_with);
    }
    for (const auto& [name, value] : settings_list(analysis.settings)) {
        lines.push_back(name + ": " + value);
    }
    lines.push_back("f0_Hz: " + round_trip_text(analysis.f0_hz()));
    lines.push_back("residual: " + round_trip_text(analysis.residual));
    if (analysis.means.windows > 0) {
        lines.push_back("mean_f_Hz: " + round_trip_text(analysis.means.mean_f_hz));
        lines.push_back("sd_mean_f_Hz: " + round_trip_text(analysis.means.sd_mean_f_hz));
        lines.push_back("noise: " + round_trip_text(analysis.means.noise));
    }
    for (const Diagnostic& diagnostic : analysis.diagnostics) {
        lines.push_back("warning: " + english(diagnostic));
    }
    return lines;
}

Status write_track_csv(OutputFile& file, const Track& track, std::span<const std::string> header,
                       const JobControl& job) {
    if (const Status written = file.write(head_text(header)); !written) {
        return written;
    }
    return write_rows(track, [&](std::string_view text, std::size_t done) {
        job.report(static_cast<double>(done) / static_cast<double>(track.rows()));
        return file.write(text);
    });
}

Status TrackCsvWriter::append(const Track& rows) {
    blocks_.push_back(rows.rows());
    return for_each_column(
        rows, [this](const auto& column) { return rows_.write(std::as_bytes(column)); });
}

Result<Track> TrackCsvWriter::next_rows(std::size_t& block) {
    constexpr std::size_t at_once = rows_per_block * blocks_at_once;
    Track track;
    do {
        Track rows(blocks_[block++]);
        const Status read = for_each_column(rows, [this](const auto& column) {
            return rows_.read(std::as_writable_bytes(column));
        });
        if (!read) {
            return read.error();
        }
        track.append(rows);
    } while (block < blocks_.size() && track.rows() + blocks_[block] <= at_once);
    return track;
}

Status TrackCsvWriter::finish(std::span<const std::string> header,
                              std::span<const FlaggedRows> flagged) {
    Status written = file_.write(head_text(header));
    std::size_t first = 0;
    for (std::size_t block = 0; written && block < blocks_.size();) {
        Result<Track> track = next_rows(block);
        if (!track) {
            return track.error();
        }
        set_flags(*track, first, flagged);
        first += track->rows();
        written = write_rows(
            *track, [this](std::string_view text, std::size_t) { return file_.write(text); });
    }
    return written;
}

}  // namespace vybeg
