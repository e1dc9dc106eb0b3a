#pragma once

#include "core/resonator/fit/posterior.h"

#include <array>
#include <cstddef>
#include <vector>

namespace vybeg {

// An event at an instant of one run: the quantity that is unknown after it gets parameters in the
// fit.
struct FittedBreak {
    std::size_t run = 0;
    double time_s = 0;
    double reach_s = 0;  // largest distance of the instant from time_s
    BreakKind kind = BreakKind::phase;
    double fall = 0;     // fall of chi^2 if it is fitted
    double shift_s = 0;  // shift of all later times: samples lost (negative: doubled) over the rate
    // Phase: the step, rad. Gain: relative changes of C and D. Start: change of the wave at the
    // instant, as a share of it.
    std::array<double, 2> size{};
};

// The instant with the largest fall of chi^2 (score_test.h) for each kind of break; a kind is
// missing if its fall may be chance. Between all neighbouring windows of each run, or, for an
// event, at each of them.
std::vector<FittedBreak> likely_breaks(const FitProblem& problem, const Posterior& posterior);

// Numbers of samples (lost: positive) whose phase at `f_hz` is that of a step.
std::vector<int> possible_samples(double step_rad, double f_hz, double rate_hz);

// The run with the break, later times shifted, without the windows that may contain it.
PhasorRun with_break(const PhasorRun& run, const FittedBreak& found);

// Size of a fitted break by its parameters; zero if no window lies after it.
std::array<double, 2> fitted_size(const FitProblem& problem, const Eigen::VectorXd& p,
                                  const FittedBreak& found);

}  // namespace vybeg
