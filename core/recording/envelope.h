#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/sample_source.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vybeg {

// Lowest and highest sample of both channels in a bucket of frames, recording units. `missing`
// where the bucket holds a NaN or an infinite sample; a channel's two are NaN where it holds
// nothing else.
struct EnvelopeBucket {
    float c_min = 0;
    float c_max = 0;
    float d_min = 0;
    float d_max = 0;
    bool missing = false;
};

// A whole recording as a pyramid of minima and maxima, 16 times coarser per level: what a raw view
// draws from, whatever the length of the recording. Immutable; the finest level has buckets of 16
// frames.
class Envelope {
public:
    // Reads the source once, front to back. Errors: those of the source, interrupted.
    static Result<std::shared_ptr<const Envelope>> build(const SampleSource& source,
                                                         const JobControl& job);

    std::int64_t frames() const { return frames_; }

    // The frames [first, end), cut into `count` buckets of equal length, whose edges are moved
    // outwards to whole multiples of the finest level's 16 frames. Cost grows with count, not with
    // the length. Preconditions: 0 <= first < end <= frames(), count >= 1.
    std::vector<EnvelopeBucket> buckets(std::int64_t first, std::int64_t end, int count) const;

private:
    // The buckets [from, to) of the finest level in one.
    EnvelopeBucket between(std::int64_t from, std::int64_t to) const;

    std::int64_t frames_ = 0;
    std::vector<std::vector<EnvelopeBucket>> levels_;
};

}  // namespace vybeg
