#include "core/report/track_csv.h"

#include "core/base/messages.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace vybeg {
namespace {

constexpr std::array value_columns{
    SlowVariable::a_A, SlowVariable::a_B,          SlowVariable::two_theta_A, SlowVariable::alpha,
    SlowVariable::f,   SlowVariable::delta_phi_CD, SlowVariable::rms};
constexpr std::array sd_columns{SlowVariable::a_A, SlowVariable::a_B, SlowVariable::two_theta_A,
                                SlowVariable::alpha, SlowVariable::f};

constexpr std::size_t rows_per_block = 4096;  // about 1 MB of text between two looks at the token

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

void append_row(std::string& text, const Track& track, std::size_t row) {
    append_round_trip(text, track.time_s()[row]);
    for (const SlowVariable variable : value_columns) {
        text += ',';
        append_round_trip(text, track.values(variable)[row]);
    }
    for (const SlowVariable variable : sd_columns) {
        text += ',';
        append_round_trip(text, track.sds(variable)[row]);
    }
    text += ',';
    text += flags_text(track.flags()[row]);
    text += '\n';
}

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

// Hands the rows to write(text, rows so far), some at a time.
template <class Write>
Status write_rows(const Track& track, Write write) {
    std::string text;
    for (std::size_t first = 0; first < track.rows(); first += rows_per_block) {
        const std::size_t end = std::min(first + rows_per_block, track.rows());
        text.clear();
        for (std::size_t row = first; row < end; ++row) {
            append_row(text, track, row);
        }
        if (const Status written = write(text, end); !written) {
            return written;
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
    return write_rows(track, [&](const std::string& text, std::size_t done) {
        job.report(static_cast<double>(done) / static_cast<double>(track.rows()));
        return file.write(text);
    });
}

Status TrackCsvWriter::append(const Track& rows) {
    return write_rows(rows,
                      [this](const std::string& text, std::size_t) { return rows_.write(text); });
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
