#pragma once

#include "core/recording/samples/recording.h"

#include <vector>

namespace vybeg {

// Factor from the unit of D to that of C, with its diagnostic; 1 if one channel has no unit or the
// ratio is unknown.
double note_units(const Channel& c, const Channel& d, std::vector<Diagnostic>& diagnostics);

// Converts channel D to the unit of C if the file has both units, with the diagnostic
// unit_converted; warns about an unknown ratio (units_differ).
void match_units(Recording& recording);

}  // namespace vybeg
