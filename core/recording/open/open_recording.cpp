#include "core/recording/open/open_recording.h"

#include "core/base/plain_text.h"
#include "core/base/read_value.h"
#include "core/recording/arrays/npy_reader.h"
#include "core/recording/arrays/raw_reader.h"
#include "core/recording/arrays/tdms_reader.h"
#include "core/recording/audio/audio_reader.h"
#include "core/recording/bytes/packed_parts.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_recording.h"
#include "core/recording/text/uff_reader.h"
#include "core/recording/times/time_grid.h"
#include "core/recording/times/uniform_times.h"
#include "core/recording/variables/array_variables.h"
#include "core/recording/variables/library_variables.h"
#include "core/recording/variables/mat_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// Basis of the decision between text and binary.
constexpr std::int64_t head_bytes = std::int64_t{1} << 16;

using Group = FileFormat::Group;

// Of a signature that does not depend on the rest of the file.
template <bool (*is)(std::string_view head)>
bool by_head(std::string_view head, const FileBytes& /*file*/) {
    return is(head);
}

bool is_audio(std::string_view head, const FileBytes& file) {
    return !audio_container(head).empty() || tag_before_flac(head, file) > 0;
}

// Level 4 has no signature.
bool is_mat4_file(std::string_view head, const FileBytes& file) {
    return is_mat4(head, file.size());
}

constexpr bool with_variables = true;
constexpr bool by_helper = true;

constexpr std::array formats{
    FileFormat{"audio", Group::audio, "wav w64 rf64 flac aif aiff caf", is_audio, open_audio,
               !with_variables, by_helper},
    FileFormat{"npy", Group::arrays, "npy", by_head<is_npy>, open_npy},
    FileFormat{"npz", Group::arrays, "npz", by_head<is_zip>, open_npz, with_variables},
    FileFormat{"mat", Group::arrays, "mat", by_head<is_mat5>, open_mat, with_variables},
    FileFormat{"tdms", Group::arrays, "tdms", by_head<is_tdms>, open_tdms},
    FileFormat{"zetlab", Group::arrays, "ana", is_zetlab, open_zetlab},
    FileFormat{"hdf5", Group::arrays, "h5 hdf5", is_hdf5, open_hdf5, with_variables, by_helper},
    FileFormat{"mat", Group::arrays, "", is_mat4_file, open_mat, with_variables},
    FileFormat{"uff", Group::arrays, "uff unv", by_head<is_uff>, open_uff},
    FileFormat{"text", Group::tables, "csv tsv txt dat", by_head<looks_like_text>, open_text},
};

}  // namespace

std::span<const FileFormat> file_formats() {
    return formats;
}

Result<std::string> file_head(const FileBytes& file) {
    return file.text(0, head_bytes);
}

const FileFormat* find_format(std::string_view head, const FileBytes& file) {
    const auto* const found = std::ranges::find_if(
        formats, [&](const FileFormat& format) { return format.is(head, file); });
    return found == formats.end() ? nullptr : found;
}

namespace {

Result<Recording> open_by_content(const std::shared_ptr<const FileBytes>& file,
                                  const OpenOptions& options, const JobControl& job) {
    if (options.raw) {
        return open_raw(file, options);
    }
    if (options.text) {
        return open_text(file, options, job);
    }
    const auto head = TRY(file_head(*file));
    const FileFormat* const format = find_format(head, *file);
    return format ? format->open(file, options, job)
                  : Result<Recording>(file->error(ErrorCode::format_unknown));
}

// One file, with everything that the options say of its samples.
Result<Recording> open_file(const std::filesystem::path& path, const OpenOptions& options,
                            const JobControl& job) {
    const auto file = TRY(FileBytes::open(path));
    auto recording = open_by_content(file, options, job);
    if (recording) {
        for (FormatPart& part : recording->format) {
            part.text = plain_text(part.text);
        }
        recording->start = plain_text(recording->start);
        for (Channel& channel : recording->channels) {
            const bool kept = options.unit.empty() && options.scale == 1;
            channel = {plain_text(channel.name), kept ? plain_text(channel.unit) : options.unit};
        }
        if (options.scale != 1) {
            recording->source =
                scaled_source(std::move(recording->source), options.scale, options.scale);
        }
        recording->file = file;
    }
    return recording;
}

// Options of one channel's file, of which `variable` counts among the names.
OpenOptions of_channel(const OpenOptions& options, int channel, std::size_t variable) {
    OpenOptions alone = options;
    alone.channel_d_file.clear();
    alone.channel_c = channel;
    alone.channel_d = channel;
    alone.variables.clear();
    const auto name = [&options](std::size_t i) {
        return i < options.variables.size() ? options.variables[i] : std::string();
    };
    if (!options.variables.empty()) {
        alone.variables = {name(variable).empty() ? name(0) : name(variable)};
    }
    if (!name(2).empty()) {
        alone.variables.insert(alone.variables.end(), {"", name(2)});
    }
    return alone;
}

bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
    std::error_code none;
    return std::filesystem::equivalent(one, other, none);
}

// The only channel of a file, or the one of that number.
Result<Recording> open_channel(const std::filesystem::path& path, const OpenOptions& options,
                               int channel, std::size_t variable, const JobControl& job) {
    auto recording = TRY(open_file(path, of_channel(options, 1, variable), job));
    if (channel == 1 || recording.channels.size() == 1) {
        return recording;
    }
    return open_file(path, of_channel(options, channel, variable), job);
}

// The same where the file has no rate: by that of the other channel's file.
Result<Recording> open_timed(const std::filesystem::path& path, const Recording& other,
                             const OpenOptions& options, int channel, std::size_t variable,
                             const JobControl& job) {
    OpenOptions timed = options;
    timed.rate_hz = other.rate_hz;
    auto recording = TRY(open_channel(path, timed, channel, variable, job));
    recording.rate_from = other.rate_from;
    recording.rate_relative_sd = other.rate_relative_sd;
    return recording;
}

bool is_untimed(const Result<Recording>& recording) {
    return !recording && recording.error().code == ErrorCode::rate_unknown;
}

// How long after a piece's last sample the next piece's first one is due, seconds beyond one
// sample period; nothing where the pieces do not state it. Starts are known to their last digit.
std::optional<double> gap_between(const Recording& piece, const Recording& next) {
    if (piece.first_time_s && next.first_time_s) {
        constexpr double day_s = 86400;
        constexpr double most_s = 3600;  // of a gap about midnight, where times of day begin anew
        const double gap_s = *next.first_time_s - *piece.first_time_s - piece.seconds();
        const double of_day_s = std::remainder(gap_s, day_s);
        const bool of_day = *next.first_time_s >= 0 && *piece.first_time_s < day_s &&
                            *next.first_time_s < *piece.first_time_s && gap_s > -1.5 * day_s;
        const bool anew = of_day && of_day_s < most_s && std::round(of_day_s * piece.rate_hz) >= 0;
        return anew ? of_day_s : gap_s;
    }
    const auto start = parse_clock(piece.start);
    const auto start_of_next = parse_clock(next.start);
    if (!start || !start_of_next || !start->timed || !start_of_next->timed) {
        return std::nullopt;
    }
    const double gap_s =
        seconds_after(*start_of_next, start->whole_s) - start->fraction_s - piece.seconds();
    const double digit_s =
        std::pow(10.0, -start->decimals) + std::pow(10.0, -start_of_next->decimals);
    return std::abs(gap_s) <= digit_s ? 0 : gap_s;
}

// Checks that a piece continues the one before it, but for its time. Errors: parts_differ.
Status check_piece(const Recording& last, const Recording& next) {
    const auto refused = [&](const char* what, const MessageArg& one, const MessageArg& other) {
        return no_parts(last, next.path.filename().string(), what, one, other);
    };
    if (!same_rates(last, next)) {
        return refused(VYBEG_MESSAGE("Words", "sample rates"), number_arg(last.rate_hz, 9, "Hz"),
                       number_arg(next.rate_hz, 9, "Hz"));
    }
    if (last.channels.size() != next.channels.size()) {
        return refused(VYBEG_MESSAGE("Words", "numbers of channels"),
                       count_arg(std::ssize(last.channels)), count_arg(std::ssize(next.channels)));
    }
    for (const int channel : {next.channel_c, next.channel_d}) {
        if (last.channel(channel).unit != next.channel(channel).unit) {
            return refused(VYBEG_MESSAGE("Words", "units"), last.channel(channel).unit,
                           next.channel(channel).unit);
        }
    }
    const auto named = [&](const Recording& piece) {
        return std::pair(piece.channel(next.channel_c).name, piece.channel(next.channel_d).name);
    };
    const auto [c, d] = named(last);
    if (c != d && named(next) == std::pair(d, c)) {
        return refused(VYBEG_MESSAGE("Words", "orders of the channels"), c + ", " + d,
                       d + ", " + c);
    }
    return {};
}

// A recording with a file for each channel (options.channel_d_file). Errors: those of both files
// and of pair_channels().
Result<Recording> open_pair(const std::filesystem::path& path, const OpenOptions& options,
                            const JobControl& job) {
    const std::filesystem::path path_d = options.channel_d_file;
    auto opened_c = open_channel(path, options, options.channel_c, 0, job);
    if (!opened_c && !is_untimed(opened_c)) {
        return opened_c.error();
    }
    auto opened_d = open_channel(path_d, options, options.channel_d, 1, job);
    if (is_untimed(opened_c) && opened_d) {
        opened_c = open_timed(path, *opened_d, options, options.channel_c, 0, job);
    } else if (is_untimed(opened_d) && opened_c) {
        opened_d = open_timed(path_d, *opened_c, options, options.channel_d, 1, job);
    }
    auto c = TRY(std::move(opened_c));
    auto d = TRY(std::move(opened_d));
    if (is_same_file(path, path_d) && c.channel_c == d.channel_c) {
        return refused_value("--channel-d", options.channel_d_file,
                             Phrase::tr("it is the channel that is read as C"));
    }
    const std::string name_d = d.path.filename().string();
    return pair_channels(std::move(c), std::move(d), name_d);
}

// A recording in pieces (options.join): each where its times, or its start, put it; gaps between
// them are missing samples (time_gap). Pieces without either follow each other
// (pieces_untimed). Errors: those of every file; parts_differ for unlike sample rates, units
// and numbers of channels, and for a piece that begins before the end of the one above it;
// format_limit for gaps that are absurdly long.
Result<Recording> open_pieces(const std::filesystem::path& path, const OpenOptions& options,
                              const JobControl& job) {
    OpenOptions alone = options;
    alone.join.clear();
    auto whole = TRY(open_file(path, alone, job));
    Recording last = whole;
    std::vector<std::filesystem::path> paths{path};
    std::vector<SourcePiece> pieces{{0, whole.source, 0, whole.frames()}};
    std::vector<FrameRange> gaps;
    std::int64_t rows = whole.frames();
    bool untimed = false;
    for (const std::string& name : options.join) {
        if (std::ranges::any_of(paths, [&](const auto& one) { return is_same_file(one, name); })) {
            return refused_value("--join", name, Phrase::tr("it is a piece already"));
        }
        paths.emplace_back(name);
        auto next = TRY(open_file(name, alone, job));
        TRY(check_piece(last, next));
        const auto gap_s = gap_between(last, next);
        untimed = untimed || !gap_s;
        const double gap = std::round(gap_s.value_or(0) * whole.rate_hz);
        const std::int64_t end = pieces.back().end();
        if (gap < 0) {
            const double end_s = static_cast<double>(end) / whole.rate_hz;
            return no_parts(last, next.path.filename().string(),
                            VYBEG_MESSAGE("Words", "end of the one and beginning of the other"),
                            number_arg(end_s, 9, "s"), number_arg(end_s + *gap_s, 9, "s"));
        }
        rows += next.frames();
        const double frames = static_cast<double>(end) + gap + static_cast<double>(next.frames());
        if (!is_plausible_grid(frames, static_cast<double>(rows))) {
            return Error{
                ErrorCode::format_limit,
                next.path.string(),
                {english(next.format),
                 Phrase::tr("it begins %1 s after the piece before it", {number_arg(*gap_s)}),
                 Phrase::tr("Analyse it as a recording of its own")}};
        }
        const auto missing = static_cast<std::int64_t>(gap);
        if (missing > 0) {
            gaps.push_back({end, missing});
        }
        for (Diagnostic diagnostic : next.diagnostics) {
            diagnostic.first_frame += diagnostic.first_frame < 0 ? 0 : end + missing;
            whole.diagnostics.push_back(std::move(diagnostic));
        }
        pieces.push_back({end + missing, next.source, 0, next.frames()});
        whole.more_files.push_back(next.file);
        whole.more_files.insert(whole.more_files.end(), next.more_files.begin(),
                                next.more_files.end());
        last = std::move(next);
    }
    report_gaps(gaps, whole.rate_hz, whole.diagnostics);
    if (untimed) {
        whole.diagnostics.push_back(
            {DiagnosticKind::pieces_untimed, {count_arg(std::ssize(pieces))}});
    }
    whole.source = joined_source(std::move(pieces));
    return whole;
}

}  // namespace

Result<Recording> open_recording(const std::filesystem::path& path, const OpenOptions& options,
                                 const JobControl& job) {
    TRY(check_options(options));
    auto recording = !options.channel_d_file.empty() ? open_pair(path, options, job)
                     : !options.join.empty()         ? open_pieces(path, options, job)
                                                     : open_file(path, options, job);
    if (recording) {
        recording->read_with = options_text(options);
    }
    return recording;
}

}  // namespace vybeg
