#pragma once

#include "core/estimators/wave/frequency_bracket.h"
#include "core/estimators/wave/wave_state.h"
#include "core/estimators/wave/window_moments.h"

namespace vybeg {

// The least-squares fit of a window with the four phasor components eliminated (variable
// projection, METHOD section 5.6): what is left is one function of the frequency.

// Power that the best phasors at w take out of the samples, with its first and second derivative by
// w.
struct ProfilePower {
    double value = 0;
    double slope = 0;
    double bend = 0;
};

ProfilePower profile_power(const Moments& moments, const WindowKernel& kernel);
double profile_power(const Projections& projections, const WindowKernel& kernel);

// The best phasors at the frequency of the moments.
Phasors best_phasors(const Projections& projections, const WindowKernel& kernel);

struct ProfileMaximum {
    double w = 0;
    Phasors phasors;
    bool converged = false;
    bool at_bound = false;  // the largest power lies at the edge of the bracket
};

// The frequency of largest power in the bracket, by Newton steps from its centre; where those leave
// the bracket or meet no concavity, by a search over the bracket first. Error of w: 1e-12 / n.
ProfileMaximum maximise_profile(const Window& window, const FrequencyBracket& bracket);

}  // namespace vybeg
