#include "core/track/unwrap.h"

#include "core/numerics/phase.h"

#include <cmath>
#include <numbers>

namespace vybeg {

void AngleUnwrapper::unwrap(Track& next_rows) {
    constexpr double pi = std::numbers::pi;
    const auto angle = next_rows.values(SlowVariable::two_theta_A);
    const auto alpha = next_rows.values(SlowVariable::alpha);
    for (std::size_t k = 0; k < next_rows.rows(); ++k) {
        if (std::isnan(angle[k])) {
            continue;
        }
        const double turned = angle[k] - two_theta_zero_;
        double branch = nearest_branch(turned, last_, pi);
        if (!any_ && branch <= -pi / 2) {
            branch += pi;
        }
        any_ = true;
        const auto half_turns = std::llround((branch - turned) / pi);
        if (half_turns % 2 != 0) {
            alpha[k] = wrap(alpha[k] + pi);
        }
        angle[k] = last_ = branch;
    }
}

void unwrap_angle(Track& track, double two_theta_zero) {
    AngleUnwrapper(two_theta_zero).unwrap(track);
}

}  // namespace vybeg
