#pragma once

#include "core/recording/checks/local_lines.h"
#include "core/recording/checks/phase_step.h"

#include <cstddef>
#include <optional>
#include <span>

namespace vybeg {

// A suspected step: it lies in [zone_begin, zone_end), and no other one in [begin, end); in
// [reach_begin, reach_end) no sample is missing. Indices into the samples.
struct Suspicion {
    std::size_t reach_begin = 0;
    std::size_t begin = 0;
    std::size_t zone_begin = 0;
    std::size_t zone_end = 0;
    std::size_t end = 0;
    std::size_t reach_end = 0;
};

constexpr double least_phase_step = 0.25;  // rad

// Whether the samples of both channels lost some inside the zone, and how many: the step that moves
// every strong line of the two stretches by one time, or nothing. The lines before the zone are run
// on and those after it run back (LocalLines); the frame is the one where they change over with the
// least squares. A number of lost samples is a candidate where, with the time moved by it, every
// line goes on with its amplitude, direction and phase, within four deviations. The mode at w
// (rad per sample) must step by least_phase_step at least, with a constant amplitude before and
// after, and lines without a step must leave half as much again of the whole reach unexplained: the
// node of a beat, a strike and noise are no step. PhaseStep::frame is an index here.
std::optional<PhaseStep> judge_step(const TwoChannels& samples, const Suspicion& where, double w);

}  // namespace vybeg
