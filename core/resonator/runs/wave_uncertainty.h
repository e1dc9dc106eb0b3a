#pragma once

#include "core/resonator/model/channel_tolerance.h"
#include "core/resonator/runs/wave_motion.h"

namespace vybeg {

// wave_motion() with `u` beside each sd: it holds also what one deviation of each channel error
// changes the number by (TRUTH principle 2), errors independent. Preconditions: as there.
WaveMotion wave_motion(const PhasorRun& run, const ChannelTolerance& tolerance);

}  // namespace vybeg
