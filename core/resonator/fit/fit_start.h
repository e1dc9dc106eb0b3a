#pragma once

#include "core/resonator/fit/map_fit.h"

namespace vybeg {

// The maximum of the posterior from no start values (FIT section 2): a still wave with the phase
// steps of the first windows and the decay of the envelope, fitted to the first windows of each run
// and to more and more of them, which keeps every phase within its basin, once with the rates and
// once with a drift instead; then to all windows with all parameters. Where that leaves more than
// twice the noise, also from the best matrix pencil, and from the best of the runs fitted alone.
// The posterior has several maxima: the lowest cost counts. Sets the prior of the damping
// anisotropy in `problem` from the decay found.
MapFit fit_from_nothing(FitProblem& problem, const JobControl& job);

// Its first part: the fits from still waves, where those come down to the noise as they lengthen.
struct WaveFit {
    MapFit best;  // of infinite cost where none does
    // The starts that do not, empty where they do.
    Eigen::VectorXd far;
    Eigen::VectorXd drifting;
};
WaveFit fit_waves(FitProblem& problem, const JobControl& job);

// Its second part: from pencils, from the runs alone, and from those starts, as far as the fit
// stays above the noise.
MapFit fit_modes(FitProblem& problem, const WaveFit& wave, const JobControl& job);

// A still wave in each run: frequency and start from its first windows, decay from the envelope.
Eigen::VectorXd still_waves(const FitProblem& problem);

// The best fit from p, with the prior of the damping anisotropy set likewise.
MapFit fit_from(FitProblem& problem, const Eigen::VectorXd& p, const JobControl& job);

}  // namespace vybeg
