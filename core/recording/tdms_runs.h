#pragma once

#include "core/recording/column_source.h"
#include "core/recording/tdms_segments.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// Collects where the values of one channel stand, segment by segment. Runs that continue each other
// become one: a file that was written piece by piece has a short table.
class TdmsRuns {
public:
    explicit TdmsRuns(std::size_t object) : object_(object) {}

    // Takes one segment's chunks. Returns what is wrong with them, or nothing. Precondition: the
    // types of the chunk are of known size.
    std::optional<std::string> take(const TdmsSegment& segment,
                                    const std::vector<TdmsRawIndex>& chunk);

    const std::vector<SampleRun>& runs() const { return runs_; }
    std::vector<SampleRun> take_runs() { return std::move(runs_); }
    std::int64_t promised() const { return promised_; }  // values, by the segments' lead-ins

private:
    void append(SampleRun run);

    std::size_t object_;
    std::int64_t promised_ = 0;
    std::vector<SampleRun> runs_;
};

}  // namespace vybeg
