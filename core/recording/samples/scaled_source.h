#pragma once

#include "core/recording/samples/sample_source.h"

#include <memory>
#include <span>

namespace vybeg {

// Multiplies samples; infinite products become NaN, a missing sample.
void scale_samples(std::span<double> values, double scale);

// The channels of `source` times their scales.
std::shared_ptr<const SampleSource> scaled_source(std::shared_ptr<const SampleSource> source,
                                                  double scale_c, double scale_d);

}  // namespace vybeg
