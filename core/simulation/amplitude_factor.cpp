#include "core/simulation/amplitude_factor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vybeg {
namespace {

constexpr double step_share = 0.005;
constexpr double at_rest = 1e-6;  // of the amplitude at the start

}  // namespace

bool has_amplitude_factor(const FreeDecay& decay) {
    return decay.dry_friction_per_s != 0 || decay.air_friction_per_s != 0 || decay.drive_per_s != 0;
}

AmplitudeFactor::AmplitudeFactor(const FreeDecay& decay, const SlowMotion& linear)
    : dry_(decay.dry_friction_per_s),
      air_(decay.air_friction_per_s),
      drive_(decay.drive_per_s),
      from_s_(decay.drive_from_s),
      to_s_(decay.drive_to_s),
      linear_(linear),
      slowest_(std::max(linear.matrix().norm(), 1 / decay.seconds)),
      least_(at_rest * linear.start().norm()) {}

double AmplitudeFactor::size_of_linear(double t) const {
    return (linear_.propagator(t) * linear_.start()).norm();
}

double AmplitudeFactor::slope(double t, double factor) const {
    const double size = size_of_linear(t);
    // Steps end at the drive's instants, so that their middle decides.
    const double drive = time_s_ >= from_s_ && time_s_ < to_s_ ? drive_ : 0;
    return drive * factor - (dry_ > 0 ? dry_ / size : 0) - air_ * factor * factor * size;
}

// The next instant at which the drive changes.
double AmplitudeFactor::next_switch() const {
    return time_s_ < from_s_ ? from_s_
           : time_s_ < to_s_ ? to_s_
                             : std::numeric_limits<double>::infinity();
}

// From time_s_ to the end of a step.
void AmplitudeFactor::advance() {
    time_s_ = end_.time_s;
    begin_ = end_;
    const double size = begin_.factor * size_of_linear(time_s_);
    if (dry_ > 0 && size < least_) {
        begin_.factor = end_.factor = begin_.slope = end_.slope = 0;
        end_.time_s = std::numeric_limits<double>::infinity();
        return;
    }
    const double rate = slowest_ + std::abs(drive_) + (dry_ > 0 ? dry_ / size : 0) + air_ * size;
    const double end = std::min(next_switch(), time_s_ + step_share / rate);
    const double h = end - time_s_;
    const double k1 = slope(time_s_, begin_.factor);
    const double k2 = slope(time_s_ + h / 2, begin_.factor + h / 2 * k1);
    const double k3 = slope(time_s_ + h / 2, begin_.factor + h / 2 * k2);
    const double k4 = slope(end, begin_.factor + h * k3);
    const double factor = std::max(begin_.factor + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), 0.0);
    begin_.slope = k1;
    end_ = {end, factor, slope(end, factor)};
}

double AmplitudeFactor::at(double t) {
    while (end_.time_s < t) {
        advance();
    }
    const double h = end_.time_s - begin_.time_s;
    if (t <= begin_.time_s || begin_.factor == 0 || h <= 0) {
        return begin_.factor;
    }
    // The cubic with the values and slopes of both ends.
    const double x = (t - begin_.time_s) / h;
    const double rise = end_.factor - begin_.factor;
    return begin_.factor + x * rise +
           x * (1 - x) * ((1 - x) * (h * begin_.slope - rise) - x * (h * end_.slope - rise));
}

}  // namespace vybeg
