#include "core/simulation/power_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;

constexpr double slowest = 1e-12;  // 1/s: least rate, that of 30,000 years

}  // namespace

PowerMotion::PowerMotion(const FreeDecay& decay, const Eigen::Matrix2cd& linear,
                         const Eigen::Vector2cd& start, double fraction)
    : linear_(linear),
      spring_(2 * std::numbers::pi / 3 * decay.frequency_per_power_hz),
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

}  // namespace vybeg
