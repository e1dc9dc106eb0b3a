#include "core/recording/variables/time_variable.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vybeg {
namespace {

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

}  // namespace

Status TimeVariable::read(const VariableReader& reader, std::int64_t first,
                          std::span<double> out) const {
    const Status status = reader.read(place, first, out);
    for (double& time : out) {
        time *= unit_s;
    }
    return status;
}

Result<TimeSteps> scan_times(const FileBytes& file, const VariableReader& reader,
                             const TimeVariable& time, std::int64_t frames, const JobControl& job) {
    // Before the last time is looked at, which may lie behind much that has to be unpacked: most
    // of what is none does not even begin like one.
    std::vector<double> block(static_cast<std::size_t>(std::min(frames, frames_per_request)));
    TRY(time.read(reader, 0, block));
    if (!std::ranges::is_sorted(block)) {
        return TimeSteps{};
    }
    double first = 0;
    double last = 0;
    for (const auto& [frame, value] : {std::pair{std::int64_t{0}, &first}, {frames - 1, &last}}) {
        TRY(time.read(reader, frame, {value, 1}));
    }
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
        if (job.cancelled()) {
            return file.error(ErrorCode::interrupted);
        }
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

}  // namespace vybeg
