#pragma once

#include "core/resonator/model/parameters.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>

namespace vybeg {

// The rates in M of METHOD section 8, the first of the shared parameters: coordinates in which
// nothing is singular where the modes coincide:
//     M = -decay I + i pi Sigma(split) - 1/2 Sigma(damping) + (rotation + i free_rotation) J
//     Sigma(v) = [[v_cos, v_sin], [v_sin, -v_cos]]        J = [[0, 1], [-1, 0]]
// A calibrated cos/sin pair of pick-offs has no free rotation; with it the traceless part is any
// complex matrix, and M that of the free model. The imaginary part of the trace is each run's own
// frequency and belongs to the run.
using SlowRates = Eigen::Matrix<double, rate_count, 1>;

// The rates of a matrix; the imaginary part of its trace is not among them.
SlowRates rates_of(const Eigen::Matrix2cd& m);

// Those of the matrix that has these eigenvalues and, as columns, these eigenvectors; empty for
// modes of one shape.
std::optional<SlowRates> rates_of_modes(const Eigen::Vector2cd& eigenvalues,
                                        const Eigen::Matrix2cd& shapes);

// The eigenvalues of a matrix, and the matrix whose exponential it is, with the logarithms of least
// imaginary part: in closed form, which does not mind coinciding modes. Precondition of the second:
// no eigenvalue is zero.
Eigen::Vector2cd eigenvalues_of(const Eigen::Matrix2cd& m);
Eigen::Matrix2cd logarithm(const Eigen::Matrix2cd& m);

// exp(M t) in closed form. With N the traceless part and N^2 = s^2 I
//     exp(M t) = exp(-decay t) (cosh(s t) I + sinh(s t)/s N)
// which is even in s: where the modes coincide (s = 0) it is a series in s^2 t^2.
class SlowDynamics {
public:
    // Of `shared` the rates count.
    explicit SlowDynamics(const Eigen::Ref<const Eigen::VectorXd>& shared);

    // M, 1/s.
    Eigen::Matrix2cd matrix() const;

    // s with Re s >= 0, Im s >= 0 where Re s = 0; the eigenvalues of M are -decay +- s, 1/s.
    std::complex<double> half_difference() const;

    // exp(M t), t in seconds.
    Eigen::Matrix2cd propagator(double t) const;

    // The same with its derivatives by the rates, in their units.
    struct Propagation {
        Eigen::Matrix2cd value;
        std::array<Eigen::Matrix2cd, rate_count> by_rate;
    };
    Propagation propagation(double t) const;

    // The mean of exp(M u) over |u| < length/2, sinhc(M length/2): factor from the motion at the
    // centre of a window of that length to its mean. `offset_hz` is the run's own frequency offset.
    Eigen::Matrix2cd window_mean(double length, double offset_hz) const;

private:
    double decay_;
    Eigen::Matrix2cd traceless_;
    std::complex<double> square_;                                  // s^2
    std::array<std::complex<double>, rate_count> square_by_rate_;  // d(s^2)/d(rate)
};

// Decides where a product with exp(M h) leads from one window to the next: not over gaps, and
// limited in number because of rounding.
class Walk {
public:
    bool step_to(double time_s, double step_s) {
        constexpr int most_steps = 64;
        const bool whole = std::abs(time_s - time_s_ - step_s) < 1e-10 * step_s;
        steps_ = whole && steps_ < most_steps ? steps_ + 1 : 0;
        time_s_ = time_s;
        return steps_ > 0;
    }

private:
    double time_s_ = -std::numeric_limits<double>::infinity();
    int steps_ = 0;
};

}  // namespace vybeg
