#pragma once

#include "core/resonator/model/phasor_run.h"

#include <cstddef>

namespace vybeg {

// The run with neighbouring windows averaged to about `most` longer ones, because the time of the
// fit grows with their number, its precision does not. Adjacent windows form exactly one window of
// the sum of their lengths (phasor_run.h); a remainder before a gap is excluded, at most a tenth of
// all. No merging if the phasors would turn by more than 0.3 rad.
PhasorRun merge_windows(const PhasorRun& run, std::size_t most);

// The windows with finite values and a deviation.
PhasorRun usable_windows(const PhasorRun& run);

}  // namespace vybeg
