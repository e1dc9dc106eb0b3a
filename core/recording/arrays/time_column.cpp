#include "core/recording/arrays/time_column.h"

#include "core/recording/times/uniform_times.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

namespace vybeg {
namespace {

constexpr std::int64_t least_times = 20;  // fewer rise within a period of a vibration, too
constexpr std::int64_t times_at_once = std::int64_t{1} << 16;
constexpr double longest_step_s = 1;

}  // namespace

Result<std::optional<SampleRate>> rate_of_times(const SampleColumn& column, double unit_s,
                                                const JobControl& job) {
    const std::optional<SampleRate> none;
    const std::int64_t frames = column.frames();
    if (frames < least_times) {
        return none;
    }
    std::vector<double> block(static_cast<std::size_t>(std::min(frames, times_at_once)));
    TRY(read_column(column, 0, block));
    const auto rises = [](double before, double after) { return before < after; };
    const auto is_whole = [](double time) { return time == std::floor(time); };
    if (std::ranges::adjacent_find(block, std::not_fn(rises)) != block.end() ||
        (unit_s == 1 && std::ranges::all_of(block, is_whole))) {
        return none;
    }
    bool single = true;
    const auto in_seconds = [&](std::span<double> times) {
        for (double& time : times) {
            single = single && is_single(time, 0);
            time *= unit_s;
        }
    };
    in_seconds(block);
    const TimeResolution expected{.single_unit_s = single ? unit_s : 0};
    const double step_s = typical_step(block, expected);
    if (!(step_s > 0 && step_s < longest_step_s)) {
        return none;
    }
    UniformTimeDetector detector(step_s, expected);
    double before = block.front() - step_s;
    for (std::int64_t at = 0; at < frames; at += times_at_once) {
        TRY(job.go_on());
        const auto times =
            std::span(block).first(static_cast<std::size_t>(std::min(times_at_once, frames - at)));
        TRY(read_column(column, at, times));
        in_seconds(times);
        for (const double time : times) {
            if (!(time >= before)) {
                return none;
            }
            detector.add(time);
            before = time;
        }
    }
    auto even = detector.judge({});
    even = even || !single ? even : detector.judge({.single_unit_s = unit_s});
    const bool whole = even && even->segments.size() == 1;
    return whole ? std::optional(
                       SampleRate{even->rate_hz, RateOrigin::time_column, even->rate_relative_sd})
                 : none;
}

}  // namespace vybeg
