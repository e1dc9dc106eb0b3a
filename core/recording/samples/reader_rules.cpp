#include "core/recording/samples/reader_rules.h"

#include "core/recording/samples/partner_file.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/samples/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <span>
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

// Only channels without a name are looked at: the names of others tell times from signals.
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
                       partner ? partner->filename().string() : std::string("FILE")});
}

Error holds_phasors(const FileBytes& file) {
    return file.error(ErrorCode::holds_log,
                      {words(VYBEG_MESSAGE("Words", "phasors of a phasemeter or a lock-in")),
                       "--phasors fixed|common|pll --y-sign +|- --amplitude peak|rms"});
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

void match_units(Recording& recording) {
    const double factor = note_units(recording.channel(recording.channel_c),
                                     recording.channel(recording.channel_d), recording.diagnostics);
    if (factor != 1) {
        recording.source = scaled_source(std::move(recording.source), 1, factor);
    }
}

Result<SampleRate> choose_rate(const FileBytes& file, std::optional<SampleRate> own,
                               const OpenOptions& options) {
    constexpr double too_coarse = 0.2;  // of times in whole seconds, for instance
    constexpr double most_hz = 1e9;     // what is above counts days, from 1900 or year 0
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

Result<Recording> complete_recording(const FileBytes& file, FoundSamples found,
                                     const OpenOptions& options) {
    const auto channels = static_cast<int>(found.channels.size());
    TRY(check_channels(file, channels, options));
    const auto rate = TRY(choose_rate(file, found.own_rate, options));
    TRY(check_frames(file, found.present_frames));
    Recording recording(std::move(static_cast<Recording&>(found)));
    recording.path = file.path();
    recording.rate_hz = rate.hz;
    constexpr double arithmetic = 1e-12;  // what is less comes from the times' sums
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
    if (recording.source) {
        TRY(check_signals(file, recording));
        if (!found.one_unit) {
            match_units(recording);
        }
    }
    note_early_end(found.promised_frames, recording);
    if (found.never_closed) {
        recording.diagnostics.push_back(
            {DiagnosticKind::file_not_closed, {count_arg(recording.frames())}, recording.frames()});
    }
    return recording;
}

}  // namespace vybeg
