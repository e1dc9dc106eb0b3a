#pragma once

#include "core/resonator/model/channel_tolerance.h"
#include "core/resonator/runs/wave_motion.h"

namespace vybeg {

// wave_motion() with `u` for each number: sd combined with the change by one deviation of each
// channel error, errors independent. Preconditions: as there.
WaveMotion wave_motion(const PhasorRun& run, const ChannelTolerance& tolerance,
                       const JobControl& job = {});

}  // namespace vybeg
