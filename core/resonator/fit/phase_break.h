#pragma once

#include "core/resonator/fit/posterior.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vybeg {

// A step in the phase of both channels of one run, due to lost or doubled samples.
struct PhaseBreak {
    std::size_t run = 0;
    double time_s = 0;   // between two windows
    double reach_s = 0;  // largest distance of the step from time_s
    double step_rad = 0;
    double fall = 0;     // fall of chi^2 if it is fitted
    double shift_s = 0;  // shift of all later times: samples lost (negative: doubled) over the rate
};

// The step between two windows with the largest fall of chi^2 (score_test.h). None if the fall is
// below three tenths of the excess of chi^2 over the noise.
std::optional<PhaseBreak> phase_break(const FitProblem& problem, const Posterior& posterior);

// Numbers of samples (lost: positive) whose phase at `f_hz` is that of the step.
std::vector<int> possible_samples(const PhaseBreak& step, double f_hz, double rate_hz);

// The run with a phase break at the step, later times shifted, without the windows that may contain
// the step.
PhasorRun with_break(const PhasorRun& run, const PhaseBreak& step);

}  // namespace vybeg
