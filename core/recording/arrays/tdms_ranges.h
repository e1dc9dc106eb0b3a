#pragma once

#include "core/recording/arrays/tdms_segments.h"
#include "core/recording/samples/column_source.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// Collects the positions of the values of one channel, segment by segment. Contiguous ranges are
// merged, so that a file written in many pieces has a short table.
class TdmsRanges {
public:
    // `scaler`: id of the chosen numbers of a DAQmx channel.
    explicit TdmsRanges(std::size_t object, std::uint32_t scaler = 0)
        : object_(object), scaler_(scaler) {}

    // Adds the chunks of one segment. A last chunk that is shorter by its segment is divided in
    // proportion among consecutive channels; in a truncated file the present bytes count. Returns
    // the fault of the chunks, if any.
    std::optional<const char*> take(const TdmsSegment& segment,
                                    const std::vector<TdmsRawIndex>& chunk);

    const std::vector<StridedRange>& ranges() const { return ranges_; }
    std::vector<StridedRange> take_ranges() { return std::move(ranges_); }
    // Number of values by the lead-ins of the segments; of an unclosed segment, whole chunks.
    std::int64_t promised() const { return promised_; }
    std::int64_t present() const { return ranges_.empty() ? 0 : ranges_.back().end(); }

private:
    void append(StridedRange range);

    std::size_t object_;
    std::uint32_t scaler_;
    std::int64_t promised_ = 0;
    std::vector<StridedRange> ranges_;
};

}  // namespace vybeg
