#include "core/resonator/model/slow_dynamics.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::Matrix2cd;
using std::numbers::pi;

constexpr Complex i{0, 1};

// dM/d(rate), except for the decay, where it is -I.
const std::array<Matrix, rate_count>& directions() {
    static const std::array<Matrix, rate_count> all = [] {
        Matrix along;
        along << 1, 0, 0, -1;
        Matrix across;
        across << 0, 1, 1, 0;
        Matrix turn;
        turn << 0, 1, -1, 0;
        return std::array<Matrix, rate_count>{
            i * pi * along, i * pi * across, -0.5 * along,       -0.5 * across,
            turn,           i * turn,        -Matrix::Identity()};
    }();
    return all;
}

// exp(-decay t) times cosh(s t), sinh(s t)/s, and the derivatives of both by s^2.
struct Series {
    Complex even;
    Complex odd;
    Complex even_by_square;
    Complex odd_by_square;
};

Series series(double decay, Complex square, double t) {
    const Complex x2 = square * (t * t);
    Series out;
    if (std::abs(x2) < 1) {
        // Powers of s^2 t^2 over factorials: the truncation error of eleven terms is 1/23! of the
        // first.
        Complex even = 0;
        Complex odd = 0;
        Complex odd_by = 0;
        for (int k = 10; k >= 0; --k) {
            const double n = 2 * k;
            even = 1.0 + even * x2 / ((n + 1) * (n + 2));
            odd = 1.0 + odd * x2 / ((n + 2) * (n + 3));
            // d/dy of sum y^k/(2k+1)! is sum (k+1) y^k/(2k+3)!, its first term 1/6.
            odd_by = 1.0 + odd_by * x2 * (k + 2.0) / ((k + 1.0) * (n + 4) * (n + 5));
        }
        const double fall = std::exp(-decay * t);
        out.even = fall * even;
        out.odd = fall * t * odd;
        out.odd_by_square = fall * t * t * t / 6 * odd_by;
    } else {
        // Each exponential contains the decay, because cosh alone would overflow in a long record.
        const Complex s = std::sqrt(square);
        const Complex plus = std::exp(-decay * t + s * t);
        const Complex minus = std::exp(-decay * t - s * t);
        out.even = (plus + minus) / 2.0;
        out.odd = (plus - minus) / (2.0 * s);
        out.odd_by_square = (t * out.even - out.odd) / (2.0 * square);
    }
    out.even_by_square = t / 2 * out.odd;
    return out;
}

}  // namespace

SlowRates rates_of(const Matrix& m) {
    const Complex along = (m(0, 0) - m(1, 1)) / 2.0;
    const Complex across = (m(0, 1) + m(1, 0)) / 2.0;
    const Complex turn = (m(0, 1) - m(1, 0)) / 2.0;
    return SlowRates{along.imag() / pi,    across.imag() / pi, -2 * along.real(),
                     -2 * across.real(),   turn.real(),        turn.imag(),
                     -m.trace().real() / 2};
}

std::optional<SlowRates> rates_of_modes(const Eigen::Vector2cd& eigenvalues, const Matrix& shapes) {
    // Of columns of unit length the determinant is the sine of the angle between the shapes.
    constexpr double least_sine = 1e-6;
    if (!(std::abs(shapes.determinant()) >
          least_sine * shapes.col(0).norm() * shapes.col(1).norm())) {
        return {};
    }
    return rates_of(shapes * eigenvalues.asDiagonal() * shapes.inverse());
}

Eigen::Vector2cd eigenvalues_of(const Matrix& m) {
    const Complex middle = m.trace() / 2.0;
    const Complex s = std::sqrt(-(m - middle * Matrix::Identity()).determinant());
    return {middle + s, middle - s};
}

Matrix logarithm(const Matrix& m) {
    const Complex middle = m.trace() / 2.0;
    const Eigen::Vector2cd values = eigenvalues_of(m);
    const Eigen::Vector2cd logs = values.array().log();
    const Complex s = (values[0] - values[1]) / 2.0;
    const Complex share = s / middle;
    // Where the modes coincide, artanh(share)/s as a series.
    const Complex along = std::abs(share) < 1e-4 ? (1.0 + share * share / 3.0) / middle
                                                 : (logs[0] - logs[1]) / (2.0 * s);
    return logs.sum() / 2.0 * Matrix::Identity() + along * (m - middle * Matrix::Identity());
}

SlowDynamics::SlowDynamics(const Eigen::Ref<const Eigen::VectorXd>& shared)
    : decay_(shared[decay_at]), traceless_(Matrix::Zero()) {
    for (std::size_t k = 0; k + 1 < rate_count; ++k) {
        traceless_ += shared[static_cast<Eigen::Index>(k)] * directions()[k];
    }
    square_ = -traceless_.determinant();
    // N^2 = s^2 I, so that d(s^2) = tr(N dN).
    for (std::size_t k = 0; k + 1 < rate_count; ++k) {
        square_by_rate_[k] = (traceless_ * directions()[k]).trace();
    }
    square_by_rate_[rate_count - 1] = 0;
}

Matrix SlowDynamics::matrix() const {
    return traceless_ - decay_ * Matrix::Identity();
}

Complex SlowDynamics::half_difference() const {
    return std::sqrt(square_);
}

Matrix SlowDynamics::propagator(double t) const {
    const Series f = series(decay_, square_, t);
    return f.even * Matrix::Identity() + f.odd * traceless_;
}

SlowDynamics::Propagation SlowDynamics::propagation(double t) const {
    const Series f = series(decay_, square_, t);
    Propagation out;
    out.value = f.even * Matrix::Identity() + f.odd * traceless_;
    const Matrix by_square = f.even_by_square * Matrix::Identity() + f.odd_by_square * traceless_;
    for (std::size_t k = 0; k + 1 < rate_count; ++k) {
        out.by_rate[k] = square_by_rate_[k] * by_square + f.odd * directions()[k];
    }
    out.by_rate[rate_count - 1] = -t * out.value;
    return out;
}

Matrix SlowDynamics::window_mean(double length, double offset_hz) const {
    const Matrix x = (matrix() + 2 * pi * offset_hz * i * Matrix::Identity()) * (length / 2);
    const Matrix x2 = x * x;
    // sum x^2k/(2k+1)!: x stays within half a turn (phasor_run.h), where the truncation error of 15
    // terms is 1e-17.
    Matrix sum = Matrix::Identity();
    for (int k = 15; k >= 1; --k) {
        sum = Matrix::Identity() + sum * x2 / ((2.0 * k) * (2 * k + 1));
    }
    return sum;
}

}  // namespace vybeg
