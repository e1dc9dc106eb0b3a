#pragma once

#include "core/recording/conditioning/calibration.h"
#include "core/recording/samples/sample_source.h"

#include <memory>

namespace vybeg {

// The source with offsets, gain ratio and delay of D taken out (calibration.h), while reading. The
// delay is a band-limited interpolation; the frames at both ends that it cannot reach are NaN in D
// and in C, and D is NaN where it would take in a missing sample. offset_auto must have been
// resolved into offsets before. Returns `source` itself where there is nothing to do.
std::shared_ptr<const SampleSource> calibrated(std::shared_ptr<const SampleSource> source,
                                               const Calibration& calibration, double rate_hz);

}  // namespace vybeg
