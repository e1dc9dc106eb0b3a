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

// Probability that Student's t with `freedom` degrees of freedom lies beyond +-limit.
inline double student_beyond(double limit, double freedom) {
    const double factor = std::exp(std::lgamma((freedom + 1) / 2) - std::lgamma(freedom / 2)) /
                          std::sqrt(freedom * std::numbers::pi);
    double sum = 0;
    constexpr int steps = 4000;
    for (int k = 0; k < steps; ++k) {  // 1/x runs from 0 to 1/limit
        const double inverse = (k + 0.5) / steps / limit;
        const double x = 1 / inverse;
        sum += std::pow(1 + x * x / freedom, -(freedom + 1) / 2) * x * x / (steps * limit);
    }
    return 2 * factor * sum;
}

}  // namespace vybeg::test
