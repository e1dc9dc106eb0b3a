#pragma once

#include <cstdint>
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

}  // namespace vybeg
