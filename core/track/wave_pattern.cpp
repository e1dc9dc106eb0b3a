#include "core/track/wave_pattern.h"

#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

double turn_part(int step, int steps) {
    return 2 * std::numbers::pi * step / steps;
}

}  // namespace

ClosedCurve polar_pattern(const WaveState& wave, int steps) {
    ClosedCurve curve;
    for (int k = 0; k <= steps; ++k) {
        const double theta = turn_part(k, steps);
        const double from_antinode = 2 * theta - wave.two_theta_A;
        curve.x.push_back(theta);
        curve.y.push_back(
            std::hypot(wave.a_A * std::cos(from_antinode), wave.a_B * std::sin(from_antinode)));
    }
    return curve;
}

ClosedCurve channel_ellipse(const WaveState& wave, int steps) {
    const double along = std::cos(wave.two_theta_A);
    const double across = std::sin(wave.two_theta_A);
    ClosedCurve curve;
    for (int k = 0; k <= steps; ++k) {
        const double tau = turn_part(k, steps);
        const double working = wave.a_A * std::cos(tau);
        const double quadrature = wave.a_B * std::sin(tau);
        curve.x.push_back(working * along - quadrature * across);
        curve.y.push_back(working * across + quadrature * along);
    }
    return curve;
}

}  // namespace vybeg
