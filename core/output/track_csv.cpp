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
// Blocks that are written as text at the same time and then handed on, some megabytes.
constexpr std::size_t blocks_at_once = 32;

// A file's name may hold a line feed; a header line may not.
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

// Room for any row.
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

// The text of some rows, in memory that is taken once and never cleared.
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

// Sets flags in the text of rows, which comes in pieces that end anywhere.
class LateFlags {
public:
    explicit LateFlags(std::span<const FlaggedRows> flagged) : flagged_(flagged) {}

    // The whole lines that the piece completes.
    std::string set_in(std::string_view piece) {
        started_ += piece;
        std::string text;
        std::size_t begin = 0;
        for (std::size_t end = started_.find('\n'); end != std::string::npos;
             end = started_.find('\n', begin)) {
            const std::string_view line = std::string_view(started_).substr(begin, end - begin);
            append_line(text, line, flags_of_next_row());
            begin = end + 1;
        }
        started_.erase(0, begin);
        return text;
    }

private:
    Flags flags_of_next_row() {
        while (begun_ < flagged_.size() && flagged_[begun_].first <= row_) {
            active_.push_back(flagged_[begun_++]);
        }
        std::erase_if(active_,
                      [this](const FlaggedRows& rows) { return rows.first + rows.count <= row_; });
        ++row_;
        Flags flags = 0;
        for (const FlaggedRows& rows : active_) {
            set(flags, rows.flag);
        }
        return flags;
    }

    static void append_line(std::string& text, std::string_view line, Flags flags) {
        if (flags == 0) {
            text += line;
        } else {
            const std::size_t field = line.rfind(',') + 1;
            text += line.substr(0, field);
            text += flags_text(flags_from_text(line.substr(field)) | flags);
        }
        text += '\n';
    }

    std::span<const FlaggedRows> flagged_;
    std::size_t begun_ = 0;            // of flagged_
    std::vector<FlaggedRows> active_;  // of those, the ones that go on
    std::string started_;              // a line without its end
    std::size_t row_ = 0;
};

// Hands the rows to write(text, rows so far), some at a time: digits take most of the time of a
// track, and are made by all threads.
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
    return write_rows(rows,
                      [this](std::string_view text, std::size_t) { return rows_.write(text); });
}

Status TrackCsvWriter::finish(std::span<const std::string> header,
                              std::span<const FlaggedRows> flagged) {
    if (Status written = file_.write(head_text(header)); !written) {
        return written;
    }
    if (flagged.empty()) {
        return rows_.empty_into([this](std::string_view piece) { return file_.write(piece); });
    }
    LateFlags late(flagged);
    return rows_.empty_into(
        [&](std::string_view piece) { return file_.write(late.set_in(piece)); });
}

}  // namespace vybeg
