#include "core/simulation/slow_motion.h"

#include <Eigen/Geometry>

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

}  // namespace vybeg
