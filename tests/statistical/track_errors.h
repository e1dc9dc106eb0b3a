#pragma once

#include "core/simulation/free_decay.h"
#include "core/track/track.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace vybeg::test {

inline constexpr std::array variables_with_sd{SlowVariable::a_A, SlowVariable::a_B,
                                              SlowVariable::two_theta_A, SlowVariable::alpha,
                                              SlowVariable::f};

// Error of a row: (2theta_A, alpha) and (2theta_A + pi, alpha + pi) are one wave.
inline double error_of(const Track& track, const Track& truth, SlowVariable variable,
                       std::size_t row, std::size_t true_row) {
    const double error = track.values(variable)[row] - truth.values(variable)[true_row];
    const bool angle = variable == SlowVariable::two_theta_A || variable == SlowVariable::alpha;
    return angle ? std::remainder(error, std::numbers::pi) : error;
}

}  // namespace vybeg::test
