#pragma once

#include "core/recording/samples/recording.h"

#include <vector>

namespace vybeg {

// What D's samples are multiplied by to be in the unit of C, and the diagnostic of it: 1 where one
// has no unit or there is no known ratio.
double note_units(const Channel& c, const Channel& d, std::vector<Diagnostic>& diagnostics);

// Brings channel D to the unit of C where the file names both: converts it and says so
// (unit_converted), or warns where there is no known ratio (units_differ).
void match_units(Recording& recording);

}  // namespace vybeg
