#include "core/recording/samples/reader_rules.h"

#include "core/base/plain_text.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/samples/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

namespace vybeg {
namespace {

constexpr int channels_needed = 2;
constexpr std::int64_t frames_needed = 5;

// Adds file_ends_early if the file has fewer frames than it states.
void note_early_end(std::int64_t promised_frames, Recording& recording) {
    const std::int64_t present = recording.frames();
    if (present < promised_frames) {
        recording.diagnostics.push_back({DiagnosticKind::file_ends_early,
                                         {count_arg(promised_frames), count_arg(present)},
                                         present,
                                         promised_frames - present});
    }
}

// Whether samples are times in s, ms, us or ns, or numbers of rows: they rise by equal steps of
// that size.
bool are_times_or_rows(std::span<const double> samples, double rate_hz) {
    constexpr double tolerance = 0.01;  // of a step
    const double step =
        (samples.back() - samples.front()) / static_cast<double>(samples.size() - 1);
    const auto is_close = [](double value, double expected) {
        return std::abs(value - expected) <= tolerance * expected;
    };
    const double ticks = step * rate_hz;
    const bool is_size_known = is_close(step, 1) || is_close(ticks, 1) || is_close(ticks, 1e3) ||
                               is_close(ticks, 1e6) || is_close(ticks, 1e9);
    return is_size_known && std::ranges::adjacent_find(samples, [&](double before, double after) {
                                return !is_close(after - before, step);
                            }) == samples.end();
}

// Only channels without a name are looked at: the names of others distinguish times from signals.
// Errors: channel_is_time; those of the source.
Status check_signals(const FileBytes& file, const Recording& recording) {
    constexpr std::int64_t looked_at = 1000;  // frames; a shorter start may rise by chance
    const auto is_nameless = [&](int channel) {
        return recording.channel(channel).name == std::to_string(channel);
    };
    if (recording.frames() < looked_at ||
        !(is_nameless(recording.channel_c) || is_nameless(recording.channel_d))) {
        return {};
    }
    std::vector<double> c(looked_at);
    std::vector<double> d(looked_at);
    TRY(recording.source->read(0, c, d));
    for (const auto& [samples, channel] :
         {std::pair(&c, recording.channel_c), std::pair(&d, recording.channel_d)}) {
        if (is_nameless(channel) && are_times_or_rows(*samples, recording.rate_hz)) {
            return file.error(ErrorCode::channel_is_time, {recording.channel(channel).name});
        }
    }
    return {};
}

}  // namespace

bool wants_one_channel(const OpenOptions& options) {
    return options.channel_c == options.channel_d;
}

Error too_few_channels(const FileBytes& file, int found) {
    if (found <= 0) {
        return file.error(ErrorCode::no_channels);
    }
    const auto partner = partner_of(file.path());
    return file.error(ErrorCode::too_few_channels,
                      {count_arg(found), count_arg(channels_needed),
                       partner ? MessageArg(partner->filename().string()) : Phrase::tr("FILE")});
}

Error holds_phasors(const FileBytes& file) {
    return file.error(ErrorCode::holds_log,
                      {Phrase::tr("phasors of a phasemeter or a lock-in"),
                       "--phasors fixed|common|pll --y-sign +|- --amplitude peak|rms"});
}

Error holds_waves(const FileBytes& file) {
    return file.error(ErrorCode::holds_log,
                      {Phrase::tr("the wave's a, b and theta"), "--columns a,b,theta"});
}

Status check_channels(const FileBytes& file, int found, const OpenOptions& options) {
    if (found < (wants_one_channel(options) ? 1 : channels_needed)) {
        return too_few_channels(file, found);
    }
    for (const int channel : {options.channel_c, options.channel_d}) {
        if (channel < 1 || channel > found) {
            return file.error(ErrorCode::channel_out_of_range,
                              {count_arg(channel), count_arg(found)});
        }
    }
    return {};
}

Status check_frames(const FileBytes& file, std::int64_t frames) {
    if (frames < frames_needed) {
        return file.error(ErrorCode::too_few_frames,
                          {count_arg(std::max<std::int64_t>(frames, 0)), count_arg(frames_needed)});
    }
    return {};
}

std::vector<Channel> numbered_channels(int count) {
    std::vector<Channel> channels;
    for (int channel = 1; channel <= count; ++channel) {
        channels.push_back({std::to_string(channel), ""});
    }
    return channels;
}

void note_unequal(std::int64_t samples_c, std::int64_t samples_d, Recording& recording) {
    recording.diagnostics.push_back(
        {DiagnosticKind::channels_unequal,
         {recording.channel(recording.channel_c).name, count_arg(samples_c),
          recording.channel(recording.channel_d).name, count_arg(samples_d)},
         std::min(samples_c, samples_d),
         std::max(samples_c, samples_d) - std::min(samples_c, samples_d)});
}

double note_units(const Channel& c, const Channel& d, std::vector<Diagnostic>& diagnostics) {
    if (c.unit.empty() || d.unit.empty()) {
        if (c.unit.empty() != d.unit.empty()) {
            const Channel& with = c.unit.empty() ? d : c;
            const Channel& without = c.unit.empty() ? c : d;
            diagnostics.push_back(
                {DiagnosticKind::unit_of_one, {with.name, with.unit, without.name}});
        }
        return 1;
    }
    const auto ratio = unit_ratio(d.unit, c.unit);
    if (!ratio) {
        diagnostics.push_back({DiagnosticKind::units_differ, {c.name, c.unit, d.name, d.unit}});
    } else if (*ratio != 1) {
        diagnostics.push_back({DiagnosticKind::unit_converted, {d.name, d.unit, c.unit}});
    }
    return ratio.value_or(1);
}

Result<SampleRate> choose_rate(const FileBytes& file, std::optional<SampleRate> own,
                               const OpenOptions& options) {
    constexpr double too_coarse = 0.2;  // of times in whole seconds, for instance
    constexpr double most_hz = 1e9;     // higher rates are of days, from 1900 or year 0
    const bool is_told = own && own->hz > 0 && own->relative_sd < too_coarse &&
                         (own->from != RateOrigin::time_column || own->hz < most_hz);
    if (is_told) {
        return *own;
    }
    if (options.rate_hz) {
        return SampleRate{*options.rate_hz, RateOrigin::option};
    }
    return file.error(ErrorCode::rate_unknown);
}

namespace {

// Converts channel D to the unit of C if the recording has both units, with the diagnostic
// unit_converted; warns about an unknown ratio (units_differ).
void match_units(Recording& recording) {
    const double factor = note_units(recording.channel(recording.channel_c),
                                     recording.channel(recording.channel_d), recording.diagnostics);
    if (factor != 1) {
        recording.source = scaled_source(std::move(recording.source), 1, factor);
    }
}

}  // namespace

Result<Recording> complete_recording(const FileBytes& file, FoundSamples found,
                                     const OpenOptions& options) {
    const auto channels = static_cast<int>(found.channels.size());
    TRY(check_channels(file, channels, options));
    const auto rate = TRY(choose_rate(file, found.own_rate, options));
    TRY(check_frames(file, std::min(found.present_frames, found.frames())));
    Recording recording(std::move(static_cast<Recording&>(found)));
    recording.path = file.path();
    recording.rate_hz = rate.hz;
    constexpr double arithmetic = 1e-12;  // smaller ones come from the times' sums
    recording.rate_relative_sd = rate.relative_sd > arithmetic ? rate.relative_sd : 0;
    recording.rate_from = rate.from;
    recording.channel_c = options.channel_c;
    recording.channel_d = options.channel_d;
    const std::string c = recording.channel(options.channel_c).name;
    const std::string d = recording.channel(options.channel_d).name;
    const bool is_chosen = !options.variables.empty() || options.channel_c > options.channel_d;
    if (!is_chosen && meaning_of(c) == Meaning::channel_d && meaning_of(d) == Meaning::channel_c) {
        recording.diagnostics.push_back({DiagnosticKind::channels_crossed, {c, d}});
    }
    TRY(check_signals(file, recording));
    if (!found.one_unit) {
        match_units(recording);
    }
    note_early_end(found.promised_frames, recording);
    if (found.never_closed) {
        recording.diagnostics.push_back(
            {DiagnosticKind::file_not_closed, {count_arg(recording.frames())}, recording.frames()});
    }
    return recording;
}

namespace {

// Channel C of one source and channel C of another.
std::shared_ptr<const SampleSource> paired_source(const std::shared_ptr<const SampleSource>& of_c,
                                                  const std::shared_ptr<const SampleSource>& of_d) {
    return source_of(
        std::min(of_c->frames(), of_d->frames()), of_c->seeks() && of_d->seeks(),
        [of_c, of_d](std::int64_t first, std::span<double> c, std::span<double> d) -> Status {
            std::vector<double> again(c.size());
            TRY(of_c->read(first, c, again));
            return of_d->read(first, d, again);
        });
}

// The channel that was opened, named by its file where it has no name.
Channel channel_of(const Recording& recording) {
    Channel channel = recording.channel(recording.channel_c);
    if (channel.name == std::to_string(recording.channel_c)) {
        channel.name = recording.path.stem().string();
    }
    return channel;
}

}  // namespace

bool same_rates(const Recording& one, const Recording& other) {
    constexpr double deviations = 4;
    constexpr double rounding = 1e-9;
    const double apart = std::abs(one.rate_hz / other.rate_hz - 1);
    return apart <= deviations * (one.rate_relative_sd + other.rate_relative_sd) + rounding;
}

Error no_parts(const Recording& one, const std::string& other, const char* what,
               const MessageArg& of_one, const MessageArg& of_other) {
    return {ErrorCode::parts_differ, one.path.string(), {other, words(what), of_one, of_other}};
}

void align_channels(double delay_s, Recording& recording, double rate_ratio) {
    constexpr double nothing = 1e-3;  // of a sample
    const double samples = delay_s * recording.rate_hz * rate_ratio;
    if (std::abs(samples) > nothing) {
        recording.diagnostics.push_back(
            {DiagnosticKind::channel_delayed, {number_arg(delay_s), number_arg(samples)}});
    }
    if (rate_ratio != 1) {
        recording.diagnostics.push_back(
            {DiagnosticKind::channel_clocks_apart, {number_arg(1e6 * (rate_ratio - 1), 4)}});
    }
    if (std::abs(samples) > nothing || rate_ratio != 1) {
        recording.source = delayed_source(std::move(recording.source), samples, 1 - rate_ratio);
    }
}

Result<Recording> pair_channels(Recording c, Recording d, const std::string& name_d) {
    constexpr double most_apart = 2e-4;
    const bool alike = same_rates(c, d);
    const bool timed =
        c.rate_from == RateOrigin::time_column && d.rate_from == RateOrigin::time_column;
    if (!alike && (!timed || std::abs(d.rate_hz / c.rate_hz - 1) > most_apart)) {
        return no_parts(c, name_d, VYBEG_MESSAGE("Words", "sample rates"),
                        number_arg(c.rate_hz, 9, "Hz"), number_arg(d.rate_hz, 9, "Hz"));
    }
    const bool same_file = c.path == d.path;
    if (!same_file && !c.start.empty() && !d.start.empty() && c.start != d.start) {
        return no_parts(c, name_d, VYBEG_MESSAGE("Words", "starts"), c.start, d.start);
    }
    double delay_s = c.first_time_s && d.first_time_s ? *d.first_time_s - *c.first_time_s : 0;
    constexpr double day_s = 86400;
    if (std::abs(delay_s) > day_s / 2 && std::min(*c.first_time_s, *d.first_time_s) >= 0 &&
        std::max(*c.first_time_s, *d.first_time_s) < day_s) {
        delay_s = std::remainder(delay_s, day_s);  // times of day, about midnight
    }
    if (delay_s >= c.seconds() || -delay_s >= d.seconds()) {
        return no_parts(c, name_d, VYBEG_MESSAGE("Words", "first times"),
                        number_arg(*c.first_time_s, 9, "s"), number_arg(*d.first_time_s, 9, "s"));
    }
    Recording pair = c;
    pair.channels = {channel_of(c), channel_of(d)};
    if (pair.channels[0].name == pair.channels[1].name) {
        pair.channels[0].name = same_file ? "1" : c.path.stem().string();
        pair.channels[1].name = same_file ? "2" : d.path.stem().string();
    }
    pair.channel_c = 1;
    pair.channel_d = 2;
    for (FormatPart& part : pair.format) {
        part.count = part.kind == FormatPart::Kind::channels ? 2 : part.count;
    }
    if (alike && d.rate_relative_sd < c.rate_relative_sd) {
        pair.rate_hz = d.rate_hz;
        pair.rate_relative_sd = d.rate_relative_sd;
    }
    pair.start = c.start.empty() ? d.start : c.start;
    for (const Diagnostic& diagnostic : d.diagnostics) {
        if (std::ranges::find(pair.diagnostics, diagnostic) == pair.diagnostics.end()) {
            pair.diagnostics.push_back(diagnostic);
        }
    }
    if (!same_file) {
        pair.more_files.push_back(d.file);
    }
    pair.more_files.insert(pair.more_files.end(), d.more_files.begin(), d.more_files.end());
    pair.source = paired_source(c.source, d.source);
    match_units(pair);
    if (c.frames() != d.frames()) {
        note_unequal(c.frames(), d.frames(), pair);
    }
    align_channels(delay_s, pair, alike ? 1 : d.rate_hz / c.rate_hz);
    return pair;
}

namespace {

// A whole word of the name, or its end after a digit or a small letter: "run_c", "runC".
bool stands_alone(std::string_view name, std::size_t at, std::size_t length) {
    const bool ends = at + length == name.size() || !is_letter(name[at + length]);
    const bool capital = name[at] >= 'A' && name[at] <= 'Z';
    const bool begins = at == 0 || !is_letter(name[at - 1]) ||
                        (capital && name[at - 1] >= 'a' && name[at - 1] <= 'z');
    return ends && begins;
}

// The number that ends before `end`, and one more, in as many digits.
std::string next_number(std::string name, std::size_t end) {
    std::size_t at = end;
    while (at > 0 && is_digit(name[at - 1])) {
        --at;
        if (name[at] != '9') {
            ++name[at];
            return name;
        }
        name[at] = '0';
    }
    return name.insert(at, 1, '1');
}

// Names that may be the partner's, the likeliest first.
std::vector<std::string> names_like(const std::string& name) {
    const auto letters =
        parts_between("C D c d X Y x y A B a b cos sin Cos Sin COS SIN I Q left right L R", ' ');
    std::vector<std::string> names;
    // LabOne counts its files after the number of the demodulator.
    constexpr std::string_view demodulator = "demods_";
    if (const std::size_t at = name.find(demodulator); at != std::string::npos) {
        std::size_t end = at + demodulator.size();
        while (end < name.size() && is_digit(name[end])) {
            ++end;
        }
        names.push_back(next_number(name, end));
    }
    for (std::size_t k = 0; k < letters.size(); k += 2) {
        const std::string_view letter = letters[k];
        const std::size_t at = name.rfind(letter);
        if (at != std::string::npos && stands_alone(name, at, letter.size())) {
            names.push_back(std::string(name).replace(at, letter.size(), letters[k + 1]));
        }
    }
    for (std::size_t end = name.size(); end > 0; --end) {
        if (is_digit(name[end - 1]) && (end == name.size() || !is_digit(name[end]))) {
            names.push_back(next_number(name, end));
        }
    }
    return names;
}

}  // namespace

std::optional<std::filesystem::path> partner_of(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    for (const std::string& name : names_like(path.stem().string())) {
        const std::filesystem::path partner = path.parent_path() / (name + ending);
        std::error_code unknown;
        if (std::filesystem::is_regular_file(partner, unknown)) {
            return partner;
        }
    }
    return std::nullopt;
}

}  // namespace vybeg
