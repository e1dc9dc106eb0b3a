#include "core/simulation/decay_motion.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

// Sigma(x) of METHOD section 8: a difference between the modes along and across the axis x.
Eigen::Matrix2cd axis_matrix(double x) {
    Eigen::Matrix2cd sigma;
    sigma << std::cos(4 * x), std::sin(4 * x), std::sin(4 * x), -std::cos(4 * x);
    return sigma;
}

// Equation (6) as a product of turns: (C, D) = Rot(2theta_A) diag(a_A, a_B) Rot(-alpha) (cos wt,
// sin wt), whose two columns are Re z and -Im z.
Eigen::Vector2cd start_phasors(const FreeDecay& decay) {
    const Eigen::Matrix2d motion = Eigen::Rotation2Dd(decay.two_theta_A).toRotationMatrix() *
                                   Eigen::Vector2d(decay.a_A, decay.a_B).asDiagonal() *
                                   Eigen::Rotation2Dd(-decay.alpha).toRotationMatrix();
    return motion.col(0).cast<Complex>() - Complex{0, 1} * motion.col(1).cast<Complex>();
}

constexpr double slowest = 1e-12;  // 1/s: least rate, that of 30,000 years
constexpr double step_share = 0.005;
constexpr double at_rest = 1e-6;     // of the amplitude at the start
constexpr std::int64_t block = 256;  // frames between two exact anchors: 256 roundings

}  // namespace

SlowMotion::SlowMotion(const FreeDecay& decay)
    : f0_hz_(decay.f0_hz), rate_hz_(decay.rate_hz), start_(start_phasors(decay)) {
    const double half_split = pi * decay.split_hz;
    const double turn = 2 * decay.bryan * decay.omega_rad_s;
    Eigen::Matrix2cd rotation;
    rotation << 0, turn, -turn, 0;
    mean_ = -1 / decay.tau_s;
    traceless_ = Complex{0, half_split} * axis_matrix(decay.theta_w) -
                 decay.damping_anisotropy_per_s / 2 * axis_matrix(decay.theta_tau) + rotation;
    half_split_ =
        std::sqrt(traceless_(0, 0) * traceless_(0, 0) + traceless_(0, 1) * traceless_(1, 0));
}

Eigen::Matrix2cd SlowMotion::propagator(double t) const {
    const Complex x = half_split_ * t;
    Complex even;
    Complex odd;  // sinh(s t)/s
    if (std::abs(x) < 1) {
        // sinh(x)/x tends to 1 without loss of digits; at x = 0, where two modes coincide, it is 1.
        const Complex decay = std::exp(mean_ * t);
        even = decay * std::cosh(x);
        odd = decay * t * (x == Complex{} ? Complex{1} : std::sinh(x) / x);
    } else {
        // Each exponential contains the decay, because cosh alone would overflow in a long record.
        const Complex plus = std::exp(mean_ * t + x);
        const Complex minus = std::exp(mean_ * t - x);
        even = (plus + minus) / 2.0;
        odd = (plus - minus) / (2.0 * half_split_);
    }
    return even * Eigen::Matrix2cd::Identity() + odd * traceless_;
}

Complex SlowMotion::carrier(double frame) const {
    return std::polar(1.0, 2 * pi * turns_at(frame, f0_hz_, rate_hz_));
}

double SlowMotion::frequency_offset_hz(const Eigen::Vector2cd& z) const {
    // The mean part of M is real: it does not affect the phase.
    return z.dot(traceless_ * z).imag() / (2 * pi * z.squaredNorm());
}

PowerMotion::PowerMotion(const FreeDecay& decay, const Eigen::Matrix2cd& linear,
                         const Eigen::Vector2cd& start, double fraction)
    : linear_(linear),
      spring_(2 * pi / 3 * decay.frequency_per_power_hz),
      damping_(decay.damping_per_power_per_s),
      fraction_(fraction),
      z_(start) {
    expand(1);
}

Eigen::Vector2cd PowerMotion::slope(const Eigen::Vector2cd& z) const {
    const double power = z.squaredNorm();
    const Complex square = z(0) * z(0) + z(1) * z(1);
    return linear_ * z + Complex{-damping_ * power, 2 * spring_ * power} * z +
           Complex{0, spring_} * square * z.conjugate();
}

// Recurrence of the coefficients; those of products are sums of products.
void PowerMotion::expand(double direction) {
    const double power = z_.squaredNorm();
    const double rate = linear_.norm() + 2 * (3 * std::abs(spring_) + std::abs(damping_)) * power;
    step_ = direction * fraction_ / std::max(rate, slowest);
    const Eigen::Matrix2cd linear = step_ * linear_;
    const Complex by_power = step_ * Complex{-damping_, 2 * spring_};
    const Complex by_square{0, step_ * spring_};
    std::array<double, order> powers{};
    std::array<Complex, order> squares{};
    c_[0] = z_(0);
    d_[0] = z_(1);
    for (std::size_t n = 0; n < order; ++n) {
        for (std::size_t j = 0; j <= n; ++j) {
            powers[n] += (c_[j] * std::conj(c_[n - j]) + d_[j] * std::conj(d_[n - j])).real();
            squares[n] += c_[j] * c_[n - j] + d_[j] * d_[n - j];
        }
        Complex c = linear(0, 0) * c_[n] + linear(0, 1) * d_[n];
        Complex d = linear(1, 0) * c_[n] + linear(1, 1) * d_[n];
        for (std::size_t j = 0; j <= n; ++j) {
            c += by_power * powers[j] * c_[n - j] + by_square * squares[j] * std::conj(c_[n - j]);
            d += by_power * powers[j] * d_[n - j] + by_square * squares[j] * std::conj(d_[n - j]);
        }
        c_[n + 1] = c / static_cast<double>(n + 1);
        d_[n + 1] = d / static_cast<double>(n + 1);
    }
}

Eigen::Vector2cd PowerMotion::sum(double x) const {
    Complex c = c_[order];
    Complex d = d_[order];
    for (std::size_t n = order; n-- > 0;) {
        c = c * x + c_[n];
        d = d * x + d_[n];
    }
    return {c, d};
}

Eigen::Vector2cd PowerMotion::at(double t) {
    // A series converges equally far backwards and forwards; only the first time can lie further
    // back.
    while (std::abs(t - begin_) > std::abs(step_)) {
        const double direction = t > begin_ ? 1 : -1;
        if (step_ * direction < 0) {
            expand(direction);
            continue;
        }
        z_ = sum(1);
        begin_ += step_;
        expand(direction);
    }
    return sum((t - begin_) / step_);
}

AmplitudeFactor::AmplitudeFactor(const FreeDecay& decay, const SlowMotion& linear)
    : decay_(decay),
      linear_(linear),
      slowest_(std::max(linear.matrix().norm(), 1 / decay.seconds)),
      least_(at_rest * linear.start().norm()) {}

double AmplitudeFactor::size_of_linear(double t) const {
    return (linear_.propagator(t) * linear_.start()).norm();
}

double AmplitudeFactor::slope(double t, double factor) const {
    const double size = size_of_linear(t);
    // Steps end at the drive's instants, so that their middle decides.
    const bool driven = time_s_ >= decay_.drive_from_s && time_s_ < decay_.drive_to_s;
    const double drive = driven ? decay_.drive_per_s : 0;
    const double dry = decay_.dry_friction_per_s;
    return drive * factor - (dry > 0 ? dry / size : 0) -
           decay_.air_friction_per_s * factor * factor * size;
}

// The next instant at which the drive changes.
double AmplitudeFactor::next_switch() const {
    return time_s_ < decay_.drive_from_s ? decay_.drive_from_s
           : time_s_ < decay_.drive_to_s ? decay_.drive_to_s
                                         : std::numeric_limits<double>::infinity();
}

// From time_s_ to the end of a step.
void AmplitudeFactor::advance() {
    time_s_ = end_.time_s;
    begin_ = end_;
    const double size = begin_.factor * size_of_linear(time_s_);
    const double dry = decay_.dry_friction_per_s;
    if (dry > 0 && size < least_) {
        begin_.factor = end_.factor = begin_.slope = end_.slope = 0;
        end_.time_s = std::numeric_limits<double>::infinity();
        return;
    }
    const double rate = slowest_ + std::abs(decay_.drive_per_s) + (dry > 0 ? dry / size : 0) +
                        decay_.air_friction_per_s * size;
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
