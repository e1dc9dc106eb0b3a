#pragma once

#include "core/recording/samples/sample_source.h"

#include <memory>
#include <span>

namespace vybeg {

// Multiplies samples; what is infinite then is NaN, a missing sample.
void scale_samples(std::span<double> values, double scale);

// Both channels of `source` times `scale`.
std::shared_ptr<const SampleSource> scaled_source(std::shared_ptr<const SampleSource> source,
                                                  double scale);

}  // namespace vybeg
