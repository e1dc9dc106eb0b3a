#pragma once

#include <cstdint>
#include <vector>

namespace vybeg {

// A place where samples were lost (or doubled): both channels' phase jumps at once. One carrier
// shows the number of samples only modulo its period: all numbers that the phase does not exclude
// stand in `candidates`.
struct PhaseStep {
    std::int64_t frame = 0;       // the first one after the step
    double phase_rad = 0;         // of the analysed mode, in (-pi, pi]
    int lost = 0;                 // of the candidates, the nearest to zero: positive lost, negative
                                  // doubled
    double phase_sd = 0;          // of phase_rad
    std::vector<int> candidates;  // ascending in size

    // Whether the phase after the step is unknown against that before it, as long as the number of
    // samples is not known otherwise.
    bool ambiguous() const { return candidates.size() > 1; }
};

}  // namespace vybeg
