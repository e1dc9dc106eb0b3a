#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vybeg {

// Part of a bucket's frames from which its extremes come.
enum class Coverage : std::uint8_t { none, some, all };

// Lowest and highest sample of both channels in a bucket of frames, recording units. `missing`: the
// bucket contains a NaN or an infinite sample.
struct EnvelopeBucket {
    float c_min = 0;
    float c_max = 0;
    float d_min = 0;
    float d_max = 0;
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

}  // namespace vybeg
