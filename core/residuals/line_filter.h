#pragma once

#include "core/analysis/settings.h"
#include "core/recording/samples/recording.h"

#include <optional>

namespace vybeg {

// The widest band-pass about the carrier (settings.f0_hz) that takes out a line, inside the filter
// that is in effect. None where the filter takes it out already, or where its transients would
// take more than a tenth of the recording at either end.
std::optional<Band> filter_without(double line_hz, const SignalSettings& settings,
                                   const Recording& recording);

}  // namespace vybeg
