#include "core/analysis/prepare.h"

#include "core/analysis/setting_table.h"
#include "core/analysis/window_noise.h"
#include "core/recording/checks/recording_check.h"
#include "core/recording/conditioning/conditioned_source.h"
#include "core/recording/samples/reader_rules.h"
#include "core/windows/carrier_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg {

Result<double> find_recording_carrier(const Recording& recording, const SignalSettings& settings,
                                      const JobControl& job) {
    TRY(validate(settings));
    const auto prepared = TRY(prepare(recording, settings, job));
    return prepared.f0_hz;
}

namespace {

// The carrier and the offsets are found in so many frames from the start of the range, where a free
// decay is strongest: half a minute at 33333 Hz, a bin of 0.03 Hz.
constexpr std::int64_t search_frames = std::int64_t{1} << 20;

struct Segment {
    std::vector<double> c;
    std::vector<double> d;
};

// Read in blocks, between which the stop token is heard.
Result<Segment> read_segment(const SampleSource& source, std::int64_t first, std::int64_t end,
                             const JobControl& job) {
    constexpr std::size_t block = std::size_t{1} << 16;
    const auto count = static_cast<std::size_t>(std::min(end - first, search_frames));
    Segment segment{std::vector<double>(count), std::vector<double>(count)};
    for (std::size_t at = 0; at < count; at += block) {
        TRY(job.go_on());
        const std::size_t length = std::min(block, count - at);
        TRY(source.read(first + static_cast<std::int64_t>(at),
                        std::span(segment.c).subspan(at, length),
                        std::span(segment.d).subspan(at, length)));
    }
    TRY(job.go_on());
    return segment;
}

// Where the carrier is looked for in so many samples.
Result<Band> search_band(const SignalSettings& settings, std::size_t count, double rate_hz) {
    // Without a band: everything above the few lowest bins, which belong to drifts of the offset.
    const double lowest = 4 * rate_hz / static_cast<double>(count);
    const Band band = settings.band.value_or(settings.filter.value_or(Band{lowest, rate_hz / 2}));
    // The spectrum of T seconds resolves 1/T.
    const double least = rate_hz / static_cast<double>(count);
    if (band.high_hz > band.low_hz && band.high_hz - band.low_hz < least &&
        band.low_hz < rate_hz / 2) {
        return Error{ErrorCode::band_too_narrow,
                     "",
                     {exact_arg(band.low_hz), exact_arg(band.high_hz), number_arg(least, 3)}};
    }
    return band;
}

Result<double> given_carrier(double f0_hz, double rate_hz) {
    if (f0_hz >= rate_hz / 2) {
        return Error{
            ErrorCode::carrier_above_half_rate, "", {number_arg(f0_hz), number_arg(rate_hz / 2)}};
    }
    return f0_hz;
}

Result<double> carrier_of(const Segment& segment, const SignalSettings& settings, double rate_hz,
                          const JobControl& job) {
    if (settings.f0_hz) {
        return given_carrier(*settings.f0_hz, rate_hz);
    }
    const auto band = TRY(search_band(settings, segment.c.size(), rate_hz));
    return find_carrier(segment.c, segment.d, rate_hz, band.low_hz, band.high_hz, job);
}

// The carrier of the frames [first, end): the given one, otherwise that of zoom_carrier(), which
// reads a few places of the range, otherwise that of find_carrier(), which holds the whole range.
Result<double> carrier_in(const SampleSource& source, std::int64_t first, std::int64_t end,
                          const SignalSettings& settings, double rate_hz, const JobControl& job) {
    if (settings.f0_hz) {
        return given_carrier(*settings.f0_hz, rate_hz);
    }
    const auto count = static_cast<std::size_t>(std::min(end - first, search_frames));
    const Result<Band> band = search_band(settings, count, rate_hz);
    if (band && source.seeks()) {
        const ReadFrames read = [&](std::int64_t at, std::span<double> c, std::span<double> d) {
            return source.read(first + at, c, d);
        };
        const auto found =
            TRY(zoom_carrier(read, count, rate_hz, band->low_hz, band->high_hz, job));
        if (found) {
            return *found;
        }
    }
    const auto segment = TRY(read_segment(source, first, end, job));
    Result<double> found = carrier_of(segment, settings, rate_hz, job);
    // Silence at the start says nothing of the rest.
    if (!found && found.error().code == ErrorCode::channels_constant &&
        end - first > search_frames) {
        return Error{ErrorCode::carrier_not_found, "", {}};
    }
    return found;
}

// Mean over as many whole periods as the segment holds; missing samples do not count.
double mean_over_periods(std::span<const double> x, double f_hz, double rate_hz) {
    const double period = rate_hz / f_hz;
    const double periods = std::floor(static_cast<double>(x.size()) / period);
    const auto count = std::min(x.size(), static_cast<std::size_t>(std::llround(periods * period)));
    double sum = 0;
    std::size_t valid = 0;
    for (const double value : x.first(count == 0 ? x.size() : count)) {
        if (std::isfinite(value)) {
            sum += value;
            ++valid;
        }
    }
    return valid > 0 ? sum / static_cast<double>(valid) : 0;
}

// Frames [first, end) of the settings' range.
Status find_range(const SampleSource& source, double rate_hz, const SignalSettings& settings,
                  ConditionedRecording& prepared) {
    const auto frames = static_cast<double>(source.frames());
    const double from = settings.from_s.value_or(0);
    const double to = settings.to_s.value_or(frames / rate_hz);
    const auto frame_at = [&](double seconds) {
        return static_cast<std::int64_t>(
            std::clamp(std::ceil(seconds * rate_hz - 1e-6), 0.0, frames));
    };
    prepared.first = frame_at(from);
    prepared.end = frame_at(to);
    if (prepared.first >= prepared.end) {
        return Error{ErrorCode::range_empty,
                     "",
                     {number_arg(from), number_arg(to), number_arg(frames / rate_hz)}};
    }
    return {};
}

// Whether both channels have samples in the range: read from its start until both have shown one.
Status check_samples(const SampleSource& source, std::int64_t first, std::int64_t end,
                     const JobControl& job) {
    constexpr std::int64_t block = 4096;
    std::vector<double> c(static_cast<std::size_t>(std::min(block, end - first)));
    std::vector<double> d(c.size());
    const auto is_number = [](double value) { return std::isfinite(value); };
    bool in_c = false;
    bool in_d = false;
    for (std::int64_t at = first; at < end && !(in_c && in_d); at += block) {
        TRY(job.go_on());
        const auto length = static_cast<std::size_t>(std::min(block, end - at));
        c.resize(length);
        d.resize(length);
        TRY(source.read(at, c, d));
        in_c = in_c || std::ranges::any_of(c, is_number);
        in_d = in_d || std::ranges::any_of(d, is_number);
    }
    if (in_c && in_d) {
        return {};
    }
    return in_c == in_d ? Error{ErrorCode::no_valid_samples, "", {}}
                        : Error{ErrorCode::channel_without_samples, "", {in_c ? "D" : "C"}};
}

// The recording's samples with gaps where some were lost.
Result<std::shared_ptr<const SampleSource>> with_gaps_for_lost(const Recording& recording,
                                                               const SignalSettings& settings,
                                                               std::vector<Diagnostic>& diagnostics,
                                                               const JobControl& job) {
    const auto f0 =
        TRY(carrier_in(*recording.source, 0, recording.frames(), settings, recording.rate_hz, job));
    const auto faults = TRY(find_faults(*recording.source, recording.rate_hz, f0, job.silent()));
    std::int64_t lost = 0;
    std::int64_t places = 0;
    for (const PhaseStep& step : faults.steps) {
        if (step.lost > 0) {
            lost += step.lost;
            ++places;
        }
    }
    if (places > 0) {
        diagnostics.push_back(
            {DiagnosticKind::gaps_inserted, {count_arg(lost), count_arg(places)}});
    }
    return with_gaps(recording.source, faults.steps);
}

// The source after calibration and band-pass, whose gain is 1 at the carrier where that is known.
Result<std::shared_ptr<const SampleSource>> condition(std::shared_ptr<const SampleSource> source,
                                                      const Calibration& calibration,
                                                      const std::optional<Band>& filter,
                                                      double rate_hz,
                                                      std::optional<double> f0_hz = {}) {
    source = calibrated(std::move(source), calibration, rate_hz);
    if (filter) {
        return band_passed(std::move(source), filter->low_hz, filter->high_hz, rate_hz, f0_hz);
    }
    return source;
}

// prepare(), whose errors may name no file.
Result<ConditionedRecording> made_ready(const Recording& recording, const SignalSettings& settings,
                                        const JobControl& job) {
    const double rate = recording.rate_hz;
    if (recording.file && recording.channel(recording.channel_c).name == "a_A" &&
        recording.channel(recording.channel_d).name == "a_B") {
        return holds_waves(*recording.file);
    }
    ConditionedRecording prepared;
    prepared.diagnostics = recording.diagnostics;
    prepared.calibration = settings.calibration;

    const double begun = job.now();
    std::shared_ptr<const SampleSource> raw = recording.source;
    if (settings.repair_lost) {
        raw = TRY(with_gaps_for_lost(recording, settings, prepared.diagnostics, job));
    }
    TRY(find_range(*raw, rate, settings, prepared));
    TRY(check_samples(*raw, prepared.first, prepared.end, job));
    if (settings.calibration.offset_auto) {
        const auto segment = TRY(read_segment(*raw, prepared.first, prepared.end, job));
        const auto f0 = TRY(carrier_of(segment, settings, rate, job));
        prepared.calibration.offset_c = mean_over_periods(segment.c, f0, rate);
        prepared.calibration.offset_d = mean_over_periods(segment.d, f0, rate);
        prepared.calibration.offset_auto = false;
    }
    const auto conditioned = TRY(condition(raw, prepared.calibration, settings.filter, rate));
    const auto f0 =
        TRY(carrier_in(*conditioned, prepared.first, prepared.end, settings, rate, job));
    prepared.f0_hz = f0;
    prepared.ahead = *condition(raw, prepared.calibration, settings.filter, rate, f0);
    prepared.rate_relative_sd = recording.rate_relative_sd;
    // The windows, which read from here on, pass all samples through the check.
    prepared.check = std::make_shared<FaultCheck>(f0, rate);
    const auto watched = checked_source(raw, prepared.check);
    prepared.source = *condition(watched, prepared.calibration, settings.filter, rate, f0);
    if (settings.filter) {
        const auto [low, high] = *settings.filter;
        prepared.filter = settings.filter;
        prepared.filter_reach = band_pass_reach(low, high, rate);
        const double lost = static_cast<double>(prepared.filter_reach) / rate;
        prepared.diagnostics.push_back({DiagnosticKind::filter_transients, {number_arg(lost, 3)}});
        const auto noise = TRY(noise_in_band(*conditioned, prepared.first, prepared.end,
                                             *settings.filter, rate, job.silent()));
        if (std::isfinite(noise)) {
            prepared.noise_in_band = noise;
        }
    }
    prepared.carrier_s = job.now() - begun;
    return prepared;
}

}  // namespace

std::string recording_name(const Recording& recording) {
    return recording.path.filename().string();
}

Error about(const Recording& recording, Error error) {
    if (error.where.empty()) {
        error.where = recording_name(recording);
    }
    return error;
}

Result<ConditionedRecording> prepare(const Recording& recording, const SignalSettings& settings,
                                     const JobControl& job) {
    Result<ConditionedRecording> prepared = made_ready(recording, settings, job);
    if (!prepared) {
        return about(recording, prepared.error());
    }
    return prepared;
}

}  // namespace vybeg
