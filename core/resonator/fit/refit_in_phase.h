#pragma once

#include "core/resonator/fit/map_fit.h"

#include <optional>

namespace vybeg {

// The fit once more to the phasors turned back by what is left of their phases, where that stands
// above the windows' noise. A phase that no motion explains (a frequency that settles, phase noise)
// takes its square from the amplitude, which spoils decay and anisotropy; to first order the second
// fit changes nothing. chi2 stays that of the measured phasors.
MapFit refit_in_phase(const FitProblem& problem, const MapFit& fit, const JobControl& job);

// Where `main` stays above the noise or has strange rates: the fit of the phasors
// turned back by what still waves of steady drift leave of the phase, if it explains angles,
// quadratures and amplitudes down to the noise. What a still wave shows in its phase alone tells
// nothing of the rates, which could follow any phase at all. Else none.
std::optional<MapFit> fit_still_in_phase(const FitProblem& problem, const MapFit& main,
                                         const JobControl& job);

}  // namespace vybeg
