#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <span>

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

}  // namespace vybeg
