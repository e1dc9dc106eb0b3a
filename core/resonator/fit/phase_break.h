#pragma once

#include "core/resonator/fit/posterior.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vybeg {

// A step in the phase of both channels of one run, as lost or doubled samples leave it.
struct PhaseBreak {
    std::size_t run = 0;
    double time_s = 0;   // between two windows
    double reach_s = 0;  // it lies within this of time_s
    double step_rad = 0;
    double fall = 0;     // of chi^2, were it fitted
    double shift_s = 0;  // of all later times: samples lost (or, negative, doubled) over the rate
};

// The step between two windows that takes most of chi^2 away (score_test.h). None where it takes
// less than three tenths of what chi^2 has beyond the noise.
std::optional<PhaseBreak> phase_break(const FitProblem& problem, const Posterior& posterior);

// Numbers of samples, lost ones positive, whose phase at `f_hz` is that of the step.
std::vector<int> possible_samples(const PhaseBreak& step, double f_hz, double rate_hz);

// The run with its phase left open there, later times shifted, and without the windows that may
// hold the step.
PhasorRun with_break(const PhasorRun& run, const PhaseBreak& step);

}  // namespace vybeg
