#pragma once

#include "core/resonator/fit/map_fit.h"

#include <optional>

namespace vybeg {

// Maximum of the posterior without start values (FIT section 2). A still wave with the phase steps
// of the first windows and the decay of the envelope is fitted to the first windows of each run and
// to increasing numbers of windows, which keeps every phase within its basin, once with the rates
// and once with a drift; then to all windows with all parameters. If more than twice the noise
// remains, further starts are the best matrix pencil and the best of the runs fitted alone. The
// posterior has several maxima; the lowest cost counts. Sets the prior of the damping anisotropy in
// `problem` from the decay.
MapFit fit_from_nothing(FitProblem& problem, const JobControl& job);

// Result of the first part: fits from still waves that reach the noise during lengthening.
struct StillFit {
    MapFit best;  // infinite cost if none does
    // Starts that do not; empty otherwise.
    Eigen::VectorXd far;
    Eigen::VectorXd drifting;
};
StillFit fit_waves(FitProblem& problem, const JobControl& job);

// Second part: starts from pencils, from the runs alone and from those of `wave`, as long as the
// fit stays above the noise.
enum class Starts { all, together };  // `together`: not those from the runs alone
MapFit fit_modes(FitProblem& problem, const StillFit& wave, const JobControl& job,
                 Starts starts = Starts::all);

// A still wave in each run: frequency and start from its first windows, decay from the envelope.
Eigen::VectorXd still_waves(const FitProblem& problem);

// The best fit from p, with the prior of the damping anisotropy set likewise.
MapFit fit_from(FitProblem& problem, const Eigen::VectorXd& p, const JobControl& job);

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
