#include "core/recording/variables/time_variable.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace vybeg {
namespace {

constexpr double longest_step_s = 1;

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
    if (const Status status = time.read(reader, 0, block); !status) {
        return status.error();
    }
    if (std::adjacent_find(block.begin(), block.end(), std::not_fn(std::less{})) != block.end()) {
        return TimeSteps{};
    }
    double first = 0;
    double last = 0;
    for (const auto& [frame, value] : {std::pair{std::int64_t{0}, &first}, {frames - 1, &last}}) {
        if (const Status status = time.read(reader, frame, {value, 1}); !status) {
            return status.error();
        }
    }
    TimeSteps steps;
    steps.step_s = (last - first) / static_cast<double>(frames - 1);
    if (!(steps.step_s > 0 && steps.step_s < longest_step_s)) {
        return steps;
    }
    steps.is_time = true;
    steps.even = true;
    double before = first - 1;
    for (std::int64_t at = 0; at < frames && steps.is_time; at += frames_per_request) {
        if (job.cancelled()) {
            return file.error(ErrorCode::interrupted);
        }
        const std::span<double> times(
            block.data(), static_cast<std::size_t>(std::min(frames_per_request, frames - at)));
        if (const Status status = time.read(reader, at, times); !status) {
            return status.error();
        }
        for (std::size_t i = 0; i < times.size(); ++i) {
            const double expected = first + steps.step_s * static_cast<double>(at + i);
            const double allowed = allowed_deviation(steps.step_s, time.resolution, times[i]);
            steps.even = steps.even && std::abs(times[i] - expected) <= allowed;
            steps.is_time = steps.is_time && times[i] > before;
            before = times[i];
        }
        job.report(static_cast<double>(at) / static_cast<double>(frames));
    }
    return steps;
}

}  // namespace vybeg
