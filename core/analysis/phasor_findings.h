#pragma once

#include "core/base/diagnostic.h"

#include <complex>
#include <span>
#include <vector>

namespace vybeg {

// What rows of phasors, step_s apart, show of a frame that they are not in: phasors_mirrored,
// phasors_locked, without the recording as first argument.
std::vector<Diagnostic> phasor_findings(double step_s, std::span<const std::complex<double>> c,
                                        std::span<const std::complex<double>> d);

}  // namespace vybeg
