#pragma once

#include "core/recording/checks/local_lines.h"
#include "core/recording/checks/phase_step.h"

#include <cstddef>
#include <optional>
#include <span>

namespace vybeg {

// A suspected step in [zone_begin, zone_end), the only one in [begin, end). No sample of
// [reach_begin, reach_end) is missing. Indices into the samples.
struct Suspicion {
    std::size_t reach_begin = 0;
    std::size_t begin = 0;
    std::size_t zone_begin = 0;
    std::size_t zone_end = 0;
    std::size_t end = 0;
    std::size_t reach_end = 0;
};

constexpr double least_phase_step = 0.25;  // rad

// Number of samples lost or doubled inside the zone: the step that shifts every strong line of the
// two segments by one time; empty without such a step. The lines before the zone are extrapolated
// forwards and those after it backwards (LocalLines); the frame is that of the change between them
// with the least sum of squares. A number of lost samples is a candidate if, with the time shifted
// by it, every line is continuous in amplitude, direction and phase, within four deviations. The
// mode at w (rad per sample) must step by at least least_phase_step, with a constant amplitude
// before and after, and lines without a step must leave 1.5 times as much of the whole reach
// unexplained; this excludes nodes of beats, strikes and noise. PhaseStep::frame is an index here.
std::optional<PhaseStep> judge_step(const TwoChannels& samples, const Suspicion& where, double w);

}  // namespace vybeg
