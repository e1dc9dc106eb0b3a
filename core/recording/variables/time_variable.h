#pragma once

#include "core/base/job_control.h"
#include "core/recording/times/uniform_times.h"
#include "core/recording/variables/variable_reader.h"

#include <cstdint>
#include <optional>

namespace vybeg {

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
    Status read(const VariableReader& reader, std::int64_t first, std::span<double> out) const;
};

// Reads `frames` times once, block by block, holding none. Errors: those of VariableReader;
// interrupted.
Result<TimeSteps> scan_times(const FileBytes& file, const VariableReader& reader,
                             const TimeVariable& time, std::int64_t frames, const JobControl& job);

}  // namespace vybeg
