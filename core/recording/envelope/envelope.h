#pragma once

#include "core/recording/envelope/envelope_block.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vybeg {

// Minima and maxima of a recording of any length, the data of a raw view. Immutable. During reading
// an envelope is a snapshot of the part read so far (envelope_builder.h); snapshots share their
// common blocks.
class Envelope {
public:
    // `blocks`: from the start of the recording on, null if not read yet. `samples`: buckets
    // sampled in advance, of equal parts of the recording; other parts have the coverage `none`.
    // Precondition: as many blocks as the frames fill.
    Envelope(std::int64_t frames, std::vector<std::shared_ptr<const EnvelopeBlock>> blocks,
             std::shared_ptr<const std::vector<EnvelopeBucket>> samples);

    std::int64_t frames() const { return frames_; }
    // Whether every frame has been read.
    bool whole() const { return whole_; }

    // The frames [first, end), cut into `count` buckets of equal length, whose edges are moved
    // outwards to whole multiples of the finest level's 16 frames. The coverage of a bucket states
    // whether all, some or none of its frames have been read; both values of a channel without
    // known samples are NaN. Cost grows with count, not with the length. Preconditions: 0 <= first
    // < end <= frames(), count >= 1.
    std::vector<EnvelopeBucket> buckets(std::int64_t first, std::int64_t end, int count) const;

private:
    // The buckets [from, to) of the finest level in one.
    EnvelopeBucket between(std::int64_t from, std::int64_t to) const;
    // Merges the samples taken in advance from these buckets; returns whether there are any.
    bool merge_samples(std::int64_t from, std::int64_t to, EnvelopeBucket& into) const;

    std::int64_t frames_;
    bool whole_;
    std::vector<std::shared_ptr<const EnvelopeBlock>> blocks_;
    std::shared_ptr<const std::vector<EnvelopeBucket>> samples_;
};

}  // namespace vybeg
