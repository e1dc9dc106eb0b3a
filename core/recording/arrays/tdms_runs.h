#pragma once

#include "core/recording/arrays/tdms_segments.h"
#include "core/recording/samples/column_source.h"

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
    // `scaler`: which of a DAQmx channel's numbers are meant.
    explicit TdmsRuns(std::size_t object, std::uint32_t scaler = 0)
        : object_(object), scaler_(scaler) {}

    // Takes one segment's chunks. A last chunk that its segment itself has shorter is shared out in
    // proportion among channels that stand one after the other; where the file is cut, what is
    // there is there. Returns what is wrong with the chunks, or nothing.
    std::optional<const char*> take(const TdmsSegment& segment,
                                    const std::vector<TdmsRawIndex>& chunk);

    const std::vector<SampleRun>& runs() const { return runs_; }
    std::vector<SampleRun> take_runs() { return std::move(runs_); }
    // Values by the segments' lead-ins; of a segment that was never closed, whole chunks.
    std::int64_t promised() const { return promised_; }
    std::int64_t present() const { return runs_.empty() ? 0 : runs_.back().end(); }

private:
    void append(SampleRun run);

    std::size_t object_;
    std::uint32_t scaler_;
    std::int64_t promised_ = 0;
    std::vector<SampleRun> runs_;
};

}  // namespace vybeg
