#pragma once

#include "core/recording/samples/recording.h"

namespace vybeg {

// Brings channel D to the unit of C where the file names both: converts it and says so
// (unit_converted), or warns where there is no known ratio (units_differ).
void match_units(Recording& recording);

}  // namespace vybeg
