#include "core/recording/open/open_parts.h"

#include "core/base/read_value.h"
#include "core/recording/samples/channel_pair.h"
#include "core/recording/text/text_clock.h"
#include "core/recording/times/time_grid.h"
#include "core/recording/times/uniform_times.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

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
                               int channel, std::size_t variable, const OpenFile& open) {
    auto recording = TRY(open(path, of_channel(options, 1, variable)));
    if (channel == 1 || recording.channels.size() == 1) {
        return recording;
    }
    return open(path, of_channel(options, channel, variable));
}

// The same where the file has no rate: by that of the other channel's file.
Result<Recording> open_timed(const std::filesystem::path& path, const Recording& other,
                             const OpenOptions& options, int channel, std::size_t variable,
                             const OpenFile& open) {
    OpenOptions timed = options;
    timed.rate_hz = other.rate_hz;
    auto recording = TRY(open_channel(path, timed, channel, variable, open));
    recording.rate_from = other.rate_from;
    recording.rate_relative_sd = other.rate_relative_sd;
    return recording;
}

bool is_untimed(const Result<Recording>& recording) {
    return !recording && recording.error().code == ErrorCode::rate_unknown;
}

// Pieces one after the other, and what is missing between them.
class JoinedSource final : public SampleSource {
public:
    struct Piece {
        std::int64_t first = 0;  // frame
        std::shared_ptr<const SampleSource> source;
    };

    explicit JoinedSource(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

    std::int64_t frames() const override {
        return pieces_.back().first + pieces_.back().source->frames();
    }
    bool seeks() const override {
        return std::ranges::all_of(pieces_, [](const Piece& p) { return p.source->seeks(); });
    }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        constexpr double missing = std::numeric_limits<double>::quiet_NaN();
        std::ranges::fill(c, missing);
        std::ranges::fill(d, missing);
        const std::int64_t end = first + std::ssize(c);
        for (const Piece& piece : pieces_) {
            const std::int64_t from = std::max(first, piece.first);
            const std::int64_t to = std::min(end, piece.first + piece.source->frames());
            if (from < to) {
                const auto part = [&](std::span<double> all) {
                    return all.subspan(static_cast<std::size_t>(from - first),
                                       static_cast<std::size_t>(to - from));
                };
                TRY(piece.source->read(from - piece.first, part(c), part(d)));
            }
        }
        return {};
    }

private:
    std::vector<Piece> pieces_;
};

// How long after a piece's last sample the next piece's first one is due, seconds beyond one
// sample period; nothing where the pieces do not tell. Starts are known to their last digit.
std::optional<double> gap_between(const Recording& piece, const Recording& next) {
    if (piece.first_time_s && next.first_time_s) {
        return *next.first_time_s - *piece.first_time_s - piece.seconds();
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

// Appends the next piece to the recording.
class Joiner {
public:
    explicit Joiner(Recording first) : whole_(std::move(first)), last_(whole_) {
        pieces_.push_back({0, whole_.source});
    }

    Status add(Recording next) {
        const auto refused = [&](const char* what, const MessageArg& one, const MessageArg& other) {
            return no_parts(last_, next.path.filename().string(), what, one, other);
        };
        if (!same_rates(last_, next)) {
            return refused(VYBEG_MESSAGE("Words", "sample rates"),
                           number_arg(last_.rate_hz, 9, "Hz"), number_arg(next.rate_hz, 9, "Hz"));
        }
        if (last_.channels.size() != next.channels.size()) {
            return refused(VYBEG_MESSAGE("Words", "numbers of channels"),
                           count_arg(std::ssize(last_.channels)),
                           count_arg(std::ssize(next.channels)));
        }
        for (const int channel : {next.channel_c, next.channel_d}) {
            const auto i = static_cast<std::size_t>(channel - 1);
            if (last_.channels[i].unit != next.channels[i].unit) {
                return refused(VYBEG_MESSAGE("Words", "units"), last_.channels[i].unit,
                               next.channels[i].unit);
            }
        }
        const auto gap_s = gap_between(last_, next);
        if (!gap_s) {
            ++without_times_;
        }
        const double gap = std::round(gap_s.value_or(0) * whole_.rate_hz);
        if (gap < 0) {
            return refused(VYBEG_MESSAGE("Words", "end of the one and beginning of the other"),
                           number_arg(seconds(), 9, "s"), number_arg(seconds() + *gap_s, 9, "s"));
        }
        rows_ += next.frames();
        const double frames = static_cast<double>(end()) + gap + static_cast<double>(next.frames());
        if (!is_plausible_grid(frames, static_cast<double>(rows_))) {
            return Error{ErrorCode::format_limit,
                         next.path.string(),
                         {english(next.format),
                          words(VYBEG_MESSAGE("Words", "it begins %1 s after the piece before it"),
                                {number_arg(*gap_s)}),
                          words(VYBEG_MESSAGE("Words", "Analyse it as a recording of its own"))}};
        }
        const std::int64_t first = end() + static_cast<std::int64_t>(gap);
        if (gap > 0) {
            gaps_.push_back({end() - 1, first});
        }
        for (Diagnostic diagnostic : next.diagnostics) {
            diagnostic.first_frame += diagnostic.first_frame < 0 ? 0 : first;
            whole_.diagnostics.push_back(std::move(diagnostic));
        }
        pieces_.push_back({first, next.source});
        whole_.more_files.push_back(next.file);
        whole_.more_files.insert(whole_.more_files.end(), next.more_files.begin(),
                                 next.more_files.end());
        last_ = std::move(next);
        return {};
    }

    Recording take() {
        report_gaps(gaps_, whole_.rate_hz, whole_.diagnostics);
        if (without_times_ > 0) {
            whole_.diagnostics.push_back(
                {DiagnosticKind::pieces_untimed, {count_arg(std::ssize(pieces_))}, -1, 0});
        }
        whole_.source = std::make_shared<JoinedSource>(std::move(pieces_));
        return std::move(whole_);
    }

private:
    std::int64_t end() const { return pieces_.back().first + pieces_.back().source->frames(); }
    double seconds() const { return static_cast<double>(end()) / whole_.rate_hz; }

    Recording whole_;
    Recording last_;
    std::vector<JoinedSource::Piece> pieces_;
    std::vector<TimeGap> gaps_;
    std::int64_t rows_ = whole_.frames();
    int without_times_ = 0;
};

}  // namespace

Result<Recording> open_pair(const std::filesystem::path& path, const OpenOptions& options,
                            const OpenFile& open) {
    const std::filesystem::path path_d = options.channel_d_file;
    auto opened_c = open_channel(path, options, options.channel_c, 0, open);
    if (!opened_c && !is_untimed(opened_c)) {
        return opened_c.error();
    }
    auto opened_d = open_channel(path_d, options, options.channel_d, 1, open);
    if (is_untimed(opened_c) && opened_d) {
        opened_c = open_timed(path, *opened_d, options, options.channel_c, 0, open);
    } else if (is_untimed(opened_d) && opened_c) {
        opened_d = open_timed(path_d, *opened_c, options, options.channel_d, 1, open);
    }
    auto c = TRY(std::move(opened_c));
    auto d = TRY(std::move(opened_d));
    if (is_same_file(path, path_d) && c.channel_c == d.channel_c) {
        return refused_value("--channel-d", options.channel_d_file,
                             words(VYBEG_MESSAGE("Words", "it is the channel that is read as C")));
    }
    const std::string name_d = d.path.filename().string();
    return pair_channels(std::move(c), std::move(d), name_d);
}

Result<Recording> open_pieces(const std::filesystem::path& path, const OpenOptions& options,
                              const OpenFile& open) {
    OpenOptions alone = options;
    alone.join.clear();
    auto first = TRY(open(path, alone));
    Joiner joiner(std::move(first));
    std::vector<std::filesystem::path> pieces{path};
    for (const std::string& name : options.join) {
        if (std::ranges::any_of(pieces, [&](const auto& one) { return is_same_file(one, name); })) {
            return refused_value("--join", name,
                                 words(VYBEG_MESSAGE("Words", "it is a piece already")));
        }
        pieces.emplace_back(name);
        auto piece = TRY(open(name, alone));
        TRY(joiner.add(std::move(piece)));
    }
    return joiner.take();
}

}  // namespace vybeg
