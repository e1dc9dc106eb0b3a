#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// Place of lost or doubled samples: a simultaneous step of both channels' phase. One carrier
// determines their number only modulo its period; `candidates` lists the numbers up to a hundred
// that agree with the phase.
struct PhaseStep {
    std::int64_t frame = 0;  // the first one after the step
    double phase_rad = 0;    // step of the analysed mode, in (-pi, pi]
    int lost = 0;            // the smallest candidate: positive lost, negative doubled
    // Whether another number may be correct: another candidate exists, or a number of this size
    // agrees with any phase by chance. The phase after the step is then unknown relative to that
    // before.
    bool is_ambiguous = false;
    double phase_sd = 0;               // of phase_rad
    std::vector<int> candidates = {};  // in the order of their sizes
};

// Samples of both channels, none missing.
struct TwoChannels {
    std::span<const double> c;
    std::span<const double> d;
};

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
