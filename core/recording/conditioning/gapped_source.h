#pragma once

#include "core/recording/checks/lost_samples_check.h"
#include "core/recording/samples/sample_source.h"

#include <memory>
#include <span>

namespace vybeg {

// The source with a gap of missing samples (NaN) wherever samples were lost, as long as what was
// lost, so that time runs on behind it. Doubled samples stay, and where the phase
// does not tell how many were lost it is the number nearest to zero. Steps are in the order of
// their frames. Returns `source` itself where nothing was lost.
std::shared_ptr<const SampleSource> with_gaps(std::shared_ptr<const SampleSource> source,
                                              std::span<const PhaseStep> steps);

}  // namespace vybeg
