#pragma once

#include "core/analysis/analysis.h"
#include "core/residuals/residuals.h"

#include <vector>

namespace vybeg {

// Names lines by their frequencies: the wave itself, the rate of the windows, images of stronger
// lines by the windows, the mains and its harmonics up to the tenth, harmonics of the carrier up to
// the tenth, also folded, and the carrier modulated by the mains. Lines that are none of these keep
// their origin.
void name_lines(std::vector<ResidualLine>& lines, const Analysis& analysis, double rate_hz,
                double bin_hz);

}  // namespace vybeg
