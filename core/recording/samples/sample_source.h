#pragma once

#include "core/base/guarded.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace vybeg {

// The two pick-off signals S_C and S_D, frame by frame on demand.
//
// Sources are immutable and may be read from several threads at once. They can be stacked: source
// of a file, calibration, band-pass.
class SampleSource {
public:
    SampleSource() = default;
    SampleSource(const SampleSource&) = delete;
    SampleSource& operator=(const SampleSource&) = delete;
    virtual ~SampleSource() = default;

    virtual std::int64_t frames() const = 0;

    // Whether frames can be read without reading those before them.
    virtual bool seeks() const { return true; }

    // Fills c and d, which have equal length, with the frames [first, first + length), in recording
    // units. A missing sample is NaN. Precondition: the frames lie in [0, frames()).
    virtual Status read(std::int64_t first, std::span<double> c, std::span<double> d) const = 0;
};

// A source of so many frames, whose `read` is SampleSource::read().
using ReadFrames =
    std::function<Status(std::int64_t first, std::span<double> c, std::span<double> d)>;
std::shared_ptr<const SampleSource> source_of(std::int64_t frames, bool seeks, ReadFrames read);

// Samples in memory. Precondition: equal lengths.
std::shared_ptr<const SampleSource> memory_source(std::vector<double> c, std::vector<double> d);

// The source whose frames `change` has changed in place.
std::shared_ptr<const SampleSource> mapped_source(
    std::shared_ptr<const SampleSource> source,
    std::function<void(std::span<double> c, std::span<double> d)> change);

// Multiplies samples; infinite products become NaN, a missing sample.
void scale_samples(std::span<double> values, double scale);

// The channels of `source` times their scales.
std::shared_ptr<const SampleSource> scaled_source(std::shared_ptr<const SampleSource> source,
                                                  double scale_c, double scale_d);

// `count` frames of a source, from `from` on, that lie from the frame `first` on.
struct SourcePiece {
    std::int64_t first = 0;
    std::shared_ptr<const SampleSource> source;
    std::int64_t from = 0;
    std::int64_t count = 0;

    std::int64_t end() const { return first + count; }
};

// Pieces one after the other; the samples between them are missing. Precondition: one piece or
// more.
std::shared_ptr<const SampleSource> joined_source(std::vector<SourcePiece> pieces);

// The source with channel D so many samples later: D(k) = S_D(k - delay), by band-limited
// interpolation. Frames that it does not reach are NaN. A delay beyond the recording leaves none.
// The delay grows by `drift` samples a sample, in steps below 2e-4 samples.
std::shared_ptr<const SampleSource> delayed_source(std::shared_ptr<const SampleSource> source,
                                                   double delay_samples, double drift = 0);

// Samples that a source computes in one go.
struct SampleBlock {
    std::int64_t index = 0;  // among the source's blocks
    std::int64_t first = 0;  // frame
    std::vector<double> c;
    std::vector<double> d;

    // Fills of the frames from `at` on those that lie in the block.
    void copy_to(std::int64_t at, std::span<double> out_c, std::span<double> out_d) const;
};

using SampleBlockPointer = std::shared_ptr<const SampleBlock>;

// The blocks used last, for reads that go on inside of one. For several threads at once.
class RecentBlocks {
public:
    explicit RecentBlocks(std::size_t most) : most_(most) {}

    // Null, where it is not kept.
    SampleBlockPointer find(std::int64_t index) const;
    void keep(SampleBlockPointer block) const;

private:
    std::size_t most_;
    Guarded<std::vector<SampleBlockPointer>> blocks_;  // the last one used first
};

}  // namespace vybeg
