#include "core/track/unwrap.h"

#include "core/numerics/phase.h"

#include <cmath>
#include <numbers>

namespace vybeg {

void unwrap_angle(Track& track, double two_theta_zero) {
    constexpr double pi = std::numbers::pi;
    const auto angle = track.values(SlowVariable::two_theta_A);
    const auto alpha = track.values(SlowVariable::alpha);
    double last = 0;
    bool any = false;
    for (std::size_t k = 0; k < track.rows(); ++k) {
        if (std::isnan(angle[k])) {
            continue;
        }
        const double turned = angle[k] - two_theta_zero;
        double branch = nearest_branch(turned, last, pi);
        if (!any && branch <= -pi / 2) {
            branch += pi;
        }
        any = true;
        const auto half_turns = std::llround((branch - turned) / pi);
        if (half_turns % 2 != 0) {
            alpha[k] = wrap(alpha[k] + pi);
        }
        angle[k] = last = branch;
    }
}

}  // namespace vybeg
