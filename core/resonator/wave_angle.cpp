#include "core/resonator/wave_angle.h"

#include "core/estimators/wave_state.h"
#include "core/numerics/phase.h"

#include <algorithm>
#include <numbers>

namespace vybeg {

WaveAngle wave_angle(const ScaledRun& run) {
    double most = 0;
    for (const Eigen::Vector2cd& z : run.z) {
        most = std::max(most, z.squaredNorm());
    }
    WaveAngle angle;
    for (std::size_t k = 0; k < run.size() && run.z[k].squaredNorm() >= 0.01 * most; ++k) {
        const double two_theta = to_wave_state({run.z[k][0], run.z[k][1]}).two_theta_A;
        angle.time_s.push_back(run.time_s[k]);
        angle.two_theta.push_back(
            angle.two_theta.empty()
                ? two_theta
                : nearest_branch(two_theta, angle.two_theta.back(), std::numbers::pi));
    }
    return angle;
}

}  // namespace vybeg
