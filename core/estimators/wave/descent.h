#pragma once

#include "core/estimators/wave/frequency_bracket.h"
#include "core/estimators/wave/functional.h"

#include <cstdint>

namespace vybeg {

// Converged when what a Newton-like step would still change is below this, relative to the wave in
// every sample. The last digit of w moves the ends of a long window by more than 1e-13.
inline double descent_tolerance(double w, std::int64_t n) {
    return 1e-13 + 6e-17 * w * static_cast<double>(n);
}

// Directions are begun afresh as often as there are parameters.
inline constexpr int descent_restart = 5;

struct Descent {
    WaveParameters parameters;
    int steps = 0;
    bool converged = false;  // the gradient vanishes, to rounding, at a minimum inside the bracket
};

// Minimises n F over a window from the given start by preconditioned conjugate gradients: exact
// step -g.d / d.H.d along each direction, a line search where the curvature d.H.d is not positive
// or the exact step does not descend.
Descent descend(const Window& window, const FrequencyBracket& bracket, const WaveParameters& start);

}  // namespace vybeg
