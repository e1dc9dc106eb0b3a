#include "core/recording/variables/variable_recording.h"

#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/times/time_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// How a vector of times runs.
struct TimeSteps {
    bool is_time = false;  // rises, in steps below a second: else it counts something
    TimeResolution resolution;
    std::optional<EvenTimes> even;
};

// Times that count in `unit_s` seconds.
struct TimeVariable {
    ChannelPlace place;
    double unit_s = 1;

    // Fills `out` with the times from the frame `first` on, in seconds.
    Status read(const VariableReader& reader, std::int64_t first, std::span<double> out) const {
        const Status status = reader.read(place, first, out);
        for (double& time : out) {
            time *= unit_s;
        }
        return status;
    }

    // The first and the last of `frames` times, s.
    Result<std::array<double, 2>> ends(const VariableReader& reader, std::int64_t frames) const {
        std::array<double, 2> found{};
        TRY(read(reader, 0, std::span(found).first(1)));
        TRY(read(reader, frames - 1, std::span(found).last(1)));
        return found;
    }
};

constexpr double longest_step_s = 1;

// What the times may have been rounded to before they were stored.
class StoredDigits {
public:
    void add(std::span<const double> times_s, double unit_s) {
        for (const double time_s : times_s) {
            const double time = time_s / unit_s;
            // But for the rounding of the unit.
            whole_ = whole_ && std::abs(time - std::round(time)) <= 1e-15 * std::abs(time);
            single_ = single_ && is_single(time, 0);
        }
    }

    TimeResolution resolution(double unit_s) const {
        return {.absolute_s = whole_ ? unit_s : 0, .single_unit_s = single_ ? unit_s : 0};
    }

private:
    bool whole_ = true;
    bool single_ = true;
};

// About the time from row to row: of the first ones, where rounding does not make them equal.
double step_of(std::span<const double> first_times_s, double mean_step_s,
               const TimeResolution& resolution) {
    const double step_s = typical_step(first_times_s, resolution);
    return step_s > 0 ? step_s : mean_step_s;
}

// Reads `frames` times once, block by block, holding none. Errors: those of VariableReader;
// interrupted.
Result<TimeSteps> scan_times(const VariableReader& reader, const TimeVariable& time,
                             std::int64_t frames, const JobControl& job) {
    // Before the last time is looked at, which may lie behind much that has to be unpacked: most
    // of what is none does not even begin like one.
    std::vector<double> block(static_cast<std::size_t>(std::min(frames, frames_per_request)));
    TRY(time.read(reader, 0, block));
    if (!std::ranges::is_sorted(block)) {
        return TimeSteps{};
    }
    const auto [first, last] = TRY(time.ends(reader, frames));
    TimeSteps steps;
    const double mean_step_s = (last - first) / static_cast<double>(frames - 1);
    if (!(mean_step_s > 0 && mean_step_s < longest_step_s)) {
        return steps;
    }
    StoredDigits digits;
    digits.add(block, time.unit_s);
    const TimeResolution expected = digits.resolution(time.unit_s);
    UniformTimeDetector detector(step_of(block, mean_step_s, expected), expected);
    bool repeated = false;
    double before = first;
    for (std::int64_t at = 0; at < frames; at += frames_per_request) {
        TRY(job.go_on());
        const std::span<double> times(
            block.data(), static_cast<std::size_t>(std::min(frames_per_request, frames - at)));
        TRY(time.read(reader, at, times));
        digits.add(times, time.unit_s);
        for (std::size_t i = 0; i < times.size(); ++i) {
            if (!(times[i] >= before)) {
                return steps;
            }
            repeated = repeated || (times[i] == before && at + static_cast<std::int64_t>(i) > 0);
            detector.add(times[i]);
            before = times[i];
        }
        job.report(static_cast<double>(at) / static_cast<double>(frames));
    }
    steps.resolution = digits.resolution(time.unit_s);
    steps.even = detector.judge({});
    if (!steps.even) {
        steps.even = detector.judge(steps.resolution);
    }
    steps.is_time = steps.even || !repeated;
    return steps;
}

// A file of which only samples and rate are not found yet.
struct Opening {
    const VariableFile& variables;
    VariableChoice choice;
    ChannelPlace c;
    ChannelPlace d;
    std::optional<TimeVariable> time;  // where it is what gives the rate
};

// All three columns at once: only where the times are uneven, which nothing but all of them tells.
Status take_uneven(const Opening& opening, const TimeResolution& resolution, FoundSamples& found) {
    const VariableReader& reader = *opening.variables.reader;
    const auto frames = static_cast<std::size_t>(opening.choice.frames);
    TimedSamples samples{std::vector<double>(frames), std::vector<double>(frames),
                         std::vector<double>(frames), resolution};
    for (std::size_t at = 0; at < frames; at += frames_per_request) {
        const std::size_t count = std::min<std::size_t>(frames_per_request, frames - at);
        const auto block = [&](std::vector<double>& column) {
            return std::span(column).subspan(at, count);
        };
        const auto first = static_cast<std::int64_t>(at);
        TRY(opening.time->read(reader, first, block(samples.time_s)));
        TRY(reader.read(opening.c, first, block(samples.c)));
        TRY(reader.read(opening.d, first, block(samples.d)));
    }
    auto grid = TRY(to_uniform_grid(samples, opening.variables.file->path().string()));
    found.own_rate = SampleRate{grid.rate_hz, RateOrigin::time_column, grid.rate_relative_sd};
    found.diagnostics = std::move(grid.diagnostics);
    found.source = std::make_shared<MemorySource>(std::move(grid.c), std::move(grid.d));
    return {};
}

// Whether the first and the last of the times have the rate that the file states. Times in steps of
// a second or more count something.
Status check_times(const Opening& opening, double rate_hz) {
    const auto ends = TRY(opening.time->ends(*opening.variables.reader, opening.choice.frames));
    const double step_s = (ends[1] - ends[0]) / static_cast<double>(opening.choice.frames - 1);
    const bool is_time = step_s > 0 && step_s < longest_step_s;
    return is_time && !same_rate(1 / step_s, rate_hz)
               ? two_rates(*opening.variables.file, opening.variables.catalogue, rate_hz,
                           1 / step_s)
               : Status();
}

// Whether D's own times, of which C has others, begin and end as C's do.
Status check_times_of_d(const Opening& opening) {
    constexpr double allowed = 1e-3;  // of a step
    const auto frames = opening.choice.frames;
    TimeVariable of_d = *opening.time;
    of_d.place.variable = *opening.choice.time_of_d;
    const auto ends_c = TRY(opening.time->ends(*opening.variables.reader, frames));
    const auto ends_d = TRY(of_d.ends(*opening.variables.reader, frames));
    const double step_s = (ends_c[1] - ends_c[0]) / static_cast<double>(frames - 1);
    const bool same = std::abs(ends_c[0] - ends_d[0]) <= allowed * step_s &&
                      std::abs(ends_c[1] - ends_d[1]) <= allowed * step_s;
    return same ? Status()
                : opening.variables.file->unsupported(
                      opening.variables.catalogue.format,
                      VYBEG_MESSAGE("Words",
                                    "C and D at different times (%1 to %2 s and "
                                    "%3 to %4 s)"),
                      {number_arg(ends_c[0], 9), number_arg(ends_c[1], 9), number_arg(ends_d[0], 9),
                       number_arg(ends_d[1], 9)});
}

Status take_samples(const Opening& opening, const OpenOptions& options, const JobControl& job,
                    FoundSamples& found) {
    found.own_rate = opening.choice.rate;
    if (opening.time && opening.choice.time_of_d) {
        TRY(check_times_of_d(opening));
    }
    if (opening.time && found.own_rate) {
        TRY(check_times(opening, found.own_rate->hz));
    } else if (opening.time) {
        const auto steps =
            TRY(scan_times(*opening.variables.reader, *opening.time, opening.choice.frames, job));
        const bool even = steps.even && steps.even->segments.size() == 1;
        if (steps.is_time && !even) {
            return take_uneven(opening, steps.resolution, found);
        }
        if (steps.is_time) {
            found.own_rate = SampleRate{steps.even->rate_hz, RateOrigin::time_column,
                                        steps.even->rate_relative_sd};
        }
    }
    // Before the work of unpacking.
    TRY(choose_rate(*opening.variables.file, found.own_rate, options));
    auto source =
        TRY(opening.variables.reader->source(opening.c, opening.d, opening.choice.frames));
    found.source = std::move(source);
    return {};
}

}  // namespace

Result<Recording> open_variables(const VariableFile& from, const OpenOptions& options,
                                 const JobControl& job) {
    const FileBytes& file = *from.file;
    auto choice = TRY(choose_variables(file, from.catalogue, options));
    const auto channels = static_cast<int>(choice.channels.size());
    TRY(check_channels(file, channels, options));
    TRY(check_frames(file, choice.frames));
    FoundSamples found;
    found.channels = choice.names;
    found.present_frames = choice.frames;
    found.never_closed = from.catalogue.not_closed;
    Opening opening{from, {}, {}, {}, {}};
    opening.c = choice.channels[static_cast<std::size_t>(options.channel_c - 1)];
    opening.d = choice.channels[static_cast<std::size_t>(options.channel_d - 1)];
    const auto& variables = from.catalogue.variables;
    found.format = {FormatPart::name(from.catalogue.format),
                    FormatPart::words(variables[static_cast<std::size_t>(opening.c.variable)].type),
                    FormatPart::channels(channels)};
    if (choice.time) {
        opening.time = TimeVariable{{*choice.time, 0}, choice.time_unit_s};
    }
    opening.choice = std::move(choice);
    TRY(take_samples(opening, options, job, found));
    return complete_recording(file, std::move(found), options);
}

}  // namespace vybeg
