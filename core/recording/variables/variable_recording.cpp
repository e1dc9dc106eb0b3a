#include "core/recording/variables/variable_recording.h"

#include "core/recording/samples/memory_source.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/times/time_grid.h"
#include "core/recording/variables/time_variable.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vybeg {
namespace {

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
        Status status = opening.time->read(reader, first, block(samples.time_s));
        status = status ? reader.read(opening.c, first, block(samples.c)) : status;
        status = status ? reader.read(opening.d, first, block(samples.d)) : status;
        if (!status) {
            return status;
        }
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
    const VariableReader& reader = *opening.variables.reader;
    std::array<double, 2> ends{};
    Status read = opening.time->read(reader, 0, std::span(ends).first(1));
    read = read ? opening.time->read(reader, opening.choice.frames - 1, std::span(ends).last(1))
                : read;
    const double step_s = (ends[1] - ends[0]) / static_cast<double>(opening.choice.frames - 1);
    const bool is_time = step_s > 0 && step_s < 1;
    return read && is_time && !same_rate(1 / step_s, rate_hz)
               ? two_rates(*opening.variables.file, opening.variables.catalogue, rate_hz,
                           1 / step_s)
               : read;
}

Status take_samples(const Opening& opening, const OpenOptions& options, const JobControl& job,
                    FoundSamples& found) {
    found.own_rate = opening.choice.rate;
    if (opening.time && found.own_rate) {
        TRY(check_times(opening, found.own_rate->hz));
    } else if (opening.time) {
        const auto steps = TRY(scan_times(*opening.variables.file, *opening.variables.reader,
                                          *opening.time, opening.choice.frames, job));
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
    auto source = TRY(opening.variables.source(opening.c, opening.d, opening.choice.frames));
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
    found.frames = choice.frames;
    found.never_closed = from.catalogue.not_closed;
    Opening opening{from, {}, {}, {}, {}};
    opening.c = choice.channels[static_cast<std::size_t>(options.channel_c - 1)];
    opening.d = choice.channels[static_cast<std::size_t>(options.channel_d - 1)];
    const auto& variables = from.catalogue.variables;
    found.format = {FormatPart::name(from.format),
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
