#include "core/residuals/window_wave.h"

#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

// Rounded up; b > 0.
std::int64_t divided_up(std::int64_t a, std::int64_t b) {
    return a / b + (a % b > 0 ? 1 : 0);
}

// The first frame that is at least as near to the centre of a window as to that of the one before.
std::int64_t own_begin(const WindowPlan& plan, std::int64_t window) {
    return divided_up(2 * plan.start(window) - plan.hop + plan.length - 1, 2);
}

}  // namespace

Frames own_frames(const WindowPlan& plan, std::int64_t window) {
    Frames own{plan.start(window), plan.start(window) + plan.length};
    if (window > 0) {
        own.first = std::max(own.first, own_begin(plan, window));
    }
    if (window + 1 < plan.count) {
        own.end = std::min(own.end, own_begin(plan, window + 1));
    }
    return own;
}

std::int64_t window_about(const WindowPlan& plan, std::int64_t frame) {
    const std::int64_t before =
        (2 * (frame - plan.first) + plan.hop - plan.length) / (2 * plan.hop);
    std::int64_t window = std::clamp<std::int64_t>(before - 1, 0, plan.count - 1);
    while (window + 1 < plan.count && own_frames(plan, window).end <= frame) {
        ++window;
    }
    return window;
}

WindowWave::WindowWave(const Analysis& analysis, std::int64_t window, double rate_hz) {
    const auto row = static_cast<std::size_t>(window);
    const auto value = [&](SlowVariable variable) { return analysis.track.values(variable)[row]; };
    const double zero = analysis.settings.calibration.two_theta_zero();
    const double angle = value(SlowVariable::two_theta_A) + zero;
    const double a_A = value(SlowVariable::a_A);
    double a_B = value(SlowVariable::a_B);
    if (has(analysis.track.flags()[row], Flag::no_quadrature)) {
        a_B = 0;
    }
    cos_c_ = a_A * std::cos(angle);
    sin_c_ = -a_B * std::sin(angle);
    cos_d_ = a_A * std::sin(angle);
    sin_d_ = a_B * std::cos(angle);
    alpha_ = value(SlowVariable::alpha);
    step_ = 2 * std::numbers::pi * value(SlowVariable::f) / rate_hz;
    centre_ = static_cast<double>(analysis.plan.start(window)) +
              0.5 * static_cast<double>(analysis.plan.length - 1);
}

bool WindowWave::exists() const {
    return std::isfinite(cos_c_ + sin_c_ + alpha_ + step_);
}

SignalPair WindowWave::at(double frame) const {
    const double tau = step_ * (frame - centre_) - alpha_;
    const double cosine = std::cos(tau);
    const double sine = std::sin(tau);
    return {cos_c_ * cosine + sin_c_ * sine, cos_d_ * cosine + sin_d_ * sine};
}

SignalPair WindowWave::amplitudes() const {
    return {std::hypot(cos_c_, sin_c_), std::hypot(cos_d_, sin_d_)};
}

}  // namespace vybeg
