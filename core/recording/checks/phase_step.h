#pragma once

#include <cstdint>
#include <vector>

namespace vybeg {

// A place where samples were lost (or doubled): both channels' phase jumps at once. One carrier
// shows their number only modulo its period: what the phase does not exclude, up to a hundred,
// stands in `candidates`.
struct PhaseStep {
    std::int64_t frame = 0;  // the first one after the step
    double phase_rad = 0;    // of the analysed mode, in (-pi, pi]
    int lost = 0;            // the smallest candidate: positive lost, negative doubled
    // Whether another number may be the true one: there is another candidate, or one of this size
    // goes with any phase by chance. The phase after the step is then unknown against that before.
    bool is_ambiguous = false;
    double phase_sd = 0;               // of phase_rad
    std::vector<int> candidates = {};  // in the order of their sizes
};

}  // namespace vybeg
