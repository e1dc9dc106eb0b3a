#pragma once

#include "core/estimators/wave/wave_state.h"
#include "core/sweep/window_sweep.h"

#include <array>
#include <cstdint>
#include <span>

namespace vybeg {

// Errors of one closed form (algorithms 1 to 4) in windows of n samples without noise: its estimate
// of a wave at f0 less that wave, root of the mean square over the phases of the carrier at the
// window, median over the waves. Next to the leakage of windows that do not hold whole half-periods
// they contain the quadrature that algorithm 1 leaves out. In the order of main_slow_variables; NaN
// where the algorithm has no value.
std::array<double, sweep_variable_count> form_leakage(Algorithm algorithm,
                                                      std::span<const WaveState> waves,
                                                      std::int64_t n, double f0_hz, double rate_hz);

}  // namespace vybeg
