#pragma once

#include "core/simulation/free_decay.h"

#include <Eigen/Core>

#include <array>
#include <complex>

namespace vybeg {

// The slow motion where frequency and damping depend on the power |z|^2 (FreeDecay), z = (c, d):
//     dz/dt = M z + i (2 pi b/3) (2|z|^2 z + (z.z) conj z) - k |z|^2 z
// by Taylor series of order 16 from step to step. A step is `fraction` of 1/rate, where rate = |M|
// + 2 (2 pi |b| + |k|) |z|^2 bounds the inverse radius of convergence: at a tenth the truncation
// error is below the rounding of a double.
class PowerMotion {
public:
    PowerMotion(const FreeDecay& decay, const Eigen::Matrix2cd& linear,
                const Eigen::Vector2cd& start, double fraction = 0.1);

    // z at t, seconds, also before 0. Only the last step is stored. Precondition: ascending times,
    // except the first.
    Eigen::Vector2cd at(double t);

    // dz/dt of the motion at z.
    Eigen::Vector2cd slope(const Eigen::Vector2cd& z) const;

private:
    static constexpr std::size_t order = 16;
    using Series = std::array<std::complex<double>, order + 1>;  // in the step's own time, 0 to 1

    void expand(double direction);
    Eigen::Vector2cd sum(double x) const;

    Eigen::Matrix2cd linear_;
    double spring_;   // 2 pi b / 3
    double damping_;  // k
    double fraction_;
    double begin_ = 0;  // of the step, s
    double step_ = 0;   // its length, s; negative: backwards
    Eigen::Vector2cd z_;
    Series c_{};
    Series d_{};
};

}  // namespace vybeg
