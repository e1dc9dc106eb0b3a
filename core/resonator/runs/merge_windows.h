#pragma once

#include "core/resonator/model/phasor_run.h"

#include <cstddef>

namespace vybeg {

// The run with neighbouring windows averaged into longer ones, so that it has about `most` of them:
// the fit's time grows with their number, its answer does not. Windows that touch are one window of
// the sum of their lengths, exactly (phasor_run.h); those before a gap that fill no whole one are
// left out, at most a tenth of all. Not merged where the phasors would turn by more than 0.3 rad.
PhasorRun merge_windows(const PhasorRun& run, std::size_t most);

// The windows that are numbers with a deviation.
PhasorRun usable_windows(const PhasorRun& run);

}  // namespace vybeg
