#pragma once

#include "core/recording/envelope/envelope_block.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vybeg {

// A recording as minima and maxima, whatever its length: what a raw view draws from. Immutable.
// While the recording is being read an envelope is a picture of how far that has come
// (envelope_builder.h); pictures share what they have in common.
class Envelope {
public:
    // `blocks`: from the recording's start on, none where it has not been read yet. `samples`: what
    // was looked at in advance, as buckets of equal parts of the recording; a part that was not has
    // the coverage `none`. Precondition: as many blocks as the frames fill.
    Envelope(std::int64_t frames, std::vector<std::shared_ptr<const EnvelopeBlock>> blocks,
             std::shared_ptr<const std::vector<EnvelopeBucket>> samples);

    std::int64_t frames() const { return frames_; }
    // Whether every frame has been read.
    bool whole() const { return whole_; }

    // The frames [first, end), cut into `count` buckets of equal length, whose edges are moved
    // outwards to whole multiples of the finest level's 16 frames. A bucket's coverage tells
    // whether all of its frames have been read, or only samples were looked at, or nothing; a
    // channel's two values are NaN where nothing of it is known. Cost grows with count, not with
    // the length. Preconditions: 0 <= first < end <= frames(), count >= 1.
    std::vector<EnvelopeBucket> buckets(std::int64_t first, std::int64_t end, int count) const;

private:
    // The buckets [from, to) of the finest level in one.
    EnvelopeBucket between(std::int64_t from, std::int64_t to) const;
    // What was looked at in advance of these; whether there is anything.
    bool merge_samples(std::int64_t from, std::int64_t to, EnvelopeBucket& into) const;

    std::int64_t frames_;
    bool whole_;
    std::vector<std::shared_ptr<const EnvelopeBlock>> blocks_;
    std::shared_ptr<const std::vector<EnvelopeBucket>> samples_;
};

}  // namespace vybeg
