#pragma once

#include "core/resonator/fit/map_fit.h"

#include <optional>

namespace vybeg {

// Repeats the fit with the phasors rotated back by the residual of their phases, if that residual
// exceeds the windows' noise. A phase that no motion explains (a frequency that settles, phase
// noise) reduces the amplitude by its square, which biases decay and anisotropy; to first order the
// second fit changes nothing. chi2 remains that of the measured phasors.
MapFit refit_in_phase(const FitProblem& problem, const MapFit& fit, const JobControl& job);

// For a `main` above the noise or with improbable rates: the fit of the phasors rotated back by the
// phase residual of still waves of steady drift, if it explains angles, quadratures and amplitudes
// down to the noise; otherwise none. The phase of a still wave determines no rates, because rates
// could follow any phase.
std::optional<MapFit> fit_still_in_phase(const FitProblem& problem, const MapFit& main,
                                         const JobControl& job);

}  // namespace vybeg
