#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace vybeg {

// Part of a bucket's frames from which its extremes come.
enum class Coverage : std::uint8_t { none, some, all };

// Lowest and highest sample of a channel, recording units.
struct ChannelRange {
    float min = 0;
    float max = 0;
};

// Those of both channels in a bucket of frames. `missing`: the bucket contains a NaN or an infinite
// sample.
struct EnvelopeBucket {
    ChannelRange c;
    ChannelRange d;
    bool missing = false;
    Coverage coverage = Coverage::all;
};

// Start value for merging: minimum above maximum, so that plain comparisons merge it.
extern const EnvelopeBucket empty_bucket;

// One bucket of the samples of both channels. Precondition: equal lengths.
EnvelopeBucket bucket_of(std::span<const double> c, std::span<const double> d);

// Merges the extremes of another bucket; keeps the coverage.
void merge(EnvelopeBucket& into, const EnvelopeBucket& other);

// A piece of a recording as a pyramid of minima and maxima, 16 times coarser per level. Immutable.
class EnvelopeBlock {
public:
    static constexpr std::int64_t leaf = 16;  // frames in a bucket of the finest level
    // In a block, except the last one of a recording.
    static constexpr std::int64_t frames = 16 << 12;
    static constexpr std::int64_t leaves = frames / leaf;

    // Precondition: equal lengths, 1 to `frames`.
    EnvelopeBlock(std::span<const double> c, std::span<const double> d);

    // Merges the buckets [from, to) of the finest level.
    void merge_leaves(std::int64_t from, std::int64_t to, EnvelopeBucket& into) const;

private:
    std::vector<std::vector<EnvelopeBucket>> levels_;
};

// Minima and maxima of a recording of any length, the data of a raw view. Immutable. During reading
// an envelope is a snapshot of the part read so far (build_envelope()); snapshots share their
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

// Samples at one place of a recording; the place runs from 0 to 1 over its length.
struct ScannedPlace {
    double place = 0;
    EnvelopeBucket seen;
};

// Samples places spread over a whole recording: each of 64 equal parts, then of 128, and so on,
// each part once, up to `most` parts or 0.3 s of the job's clock. Arguments of `look`: number of
// the part, number of parts. The result has one bucket per part, for the largest number of parts
// completed in time; empty if fewer than 64. Errors: those of `look`, interrupted.
Result<std::vector<EnvelopeBucket>> sparse_scan(
    std::int64_t most, const JobControl& job,
    const std::function<Result<ScannedPlace>(std::int64_t part, std::int64_t parts)>& look);

// Receives snapshots of a growing envelope.
using EnvelopeSink = std::function<void(std::shared_ptr<const Envelope>)>;

// The envelope of a recording. A long source that seeks is first sampled at up to 2048 places over
// its length, for at most 0.3 s of the job's clock; then every source is read once, front to back.
// `sink` receives a snapshot after the sampling and others at most every 0.1 s of that clock, but
// not the last one, which is the result. Errors: those of the source, interrupted.
Result<std::shared_ptr<const Envelope>> build_envelope(const SampleSource& source,
                                                       const JobControl& job,
                                                       const EnvelopeSink& sink = {});

// Envelope of samples only: buckets of equal parts of the recording. Precondition: frames >= 1.
std::shared_ptr<const Envelope> sampled_envelope(std::int64_t frames,
                                                 std::vector<EnvelopeBucket> samples);

}  // namespace vybeg
