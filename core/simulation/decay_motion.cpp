#include "core/simulation/decay_motion.h"

#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr std::int64_t block = 256;  // frames between two exact anchors: 256 roundings

}  // namespace

DecayMotion::DecayMotion(const FreeDecay& decay, double late_s)
    : decay_(decay),
      late_s_(late_s),
      linear_(decay),
      turns_(decay.frequency_drift_hz_s != 0 || decay.settling_hz != 0),
      earlier_(std::polar(1.0, -2 * pi * std::remainder(decay.f0_hz * late_s, 1.0))),
      step_(linear_.propagator(1 / decay.rate_hz) * linear_.carrier(1)) {
    if (decay.frequency_per_power_hz != 0 || decay.damping_per_power_per_s != 0) {
        by_power_.emplace(decay, linear_.matrix(), linear_.start());
    }
    if (has_amplitude_factor(decay)) {
        factor_.emplace(decay, linear_);
    }
}

// e^{2 pi i int (f - f0) dt} from t = 0, in long double: a drift makes 1e5 turns in an hour.
Complex DecayMotion::turn(double frame) const {
    const long double t = static_cast<long double>(frame) / decay_.rate_hz - late_s_;
    const long double settled = -std::expm1(-t / decay_.settling_time_s);
    const long double turns = decay_.frequency_drift_hz_s * t * t / 2 +
                              decay_.settling_hz * decay_.settling_time_s * settled;
    return std::polar(1.0, 2 * pi * static_cast<double>(std::remainder(turns, 1.0L)));
}

Eigen::Vector2cd DecayMotion::at_frame(double frame) {
    if (!by_power_ && !factor_ && !turns_ && late_s_ == 0) {
        return linear_.at_frame(frame);
    }
    const double t = frame / decay_.rate_hz - late_s_;
    Eigen::Vector2cd z =
        by_power_ ? by_power_->at(t) : Eigen::Vector2cd(linear_.propagator(t) * linear_.start());
    if (factor_) {
        z *= factor_->at(t);
    }
    const Complex carrier = linear_.carrier(frame) * earlier_;
    return z * (turns_ ? carrier * turn(frame) : carrier);
}

Eigen::Vector2cd DecayMotion::next() {
    const auto frame = static_cast<double>(frame_);
    if (by_power_ || factor_) {
        ++frame_;
        return at_frame(frame);
    }
    if (frame_ % block == 0) {
        z_ = late_s_ == 0 ? linear_.at_frame(frame)
                          : Eigen::Vector2cd(linear_.propagator(frame / decay_.rate_hz - late_s_) *
                                             linear_.start() * (linear_.carrier(frame) * earlier_));
    }
    const Eigen::Vector2cd now = turns_ ? Eigen::Vector2cd(z_ * turn(frame)) : z_;
    z_ = step_ * z_;
    ++frame_;
    return now;
}

double DecayMotion::frequency_hz(double frame, const Eigen::Vector2cd& phasors) const {
    const double t = frame / decay_.rate_hz - late_s_;
    const double beside =
        by_power_ ? phasors.dot(by_power_->slope(phasors)).imag() / (2 * pi * phasors.squaredNorm())
                  : linear_.frequency_offset_hz(phasors);
    if (!turns_) {
        return decay_.f0_hz + beside;
    }
    return decay_.f0_hz + (decay_.frequency_drift_hz_s * t +
                           decay_.settling_hz * std::exp(-t / decay_.settling_time_s) + beside);
}

}  // namespace vybeg
