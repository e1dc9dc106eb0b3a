#pragma once

#include "core/recording/samples/sample_source.h"

#include <memory>

namespace vybeg {

// The source with channel D so many samples later: D(k) = S_D(k - delay), by band-limited
// interpolation. Frames that it does not reach are NaN. A delay beyond the recording leaves none.
std::shared_ptr<const SampleSource> delayed_source(std::shared_ptr<const SampleSource> source,
                                                   double delay_samples);

}  // namespace vybeg
