#include "core/resonator/axis_estimates.h"

#include "core/base/number_text.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace vybeg {

AxisEstimate axis_estimate(const DeltaMethod& delta, const Shared& shared, int first) {
    const double x = shared[first];
    const double y = shared[first + 1];
    const double size = std::hypot(x, y);
    const Eigen::Matrix2d pair = delta.covariance().block<2, 2>(first, first);
    const double most =
        std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(pair, Eigen::EigenvaluesOnly)
                      .eigenvalues()[1]);
    AxisEstimate out;
    if (size < 5 * most) {
        out.size = {size, most, {}};
        out.axis.reason = {ReasonCode::below_noise, {short_text(size, 3), short_text(most, 3)}};
        return out;
    }
    Eigen::VectorXd by = delta.gradient();
    by.segment<2>(first) << x / size, y / size;
    out.size = delta.estimate(size, by);
    by.segment<2>(first) << -y / (4 * size * size), x / (4 * size * size);
    double axis = std::atan2(y, x) / 4;
    if (axis <= -std::numbers::pi / 4) {
        axis += std::numbers::pi / 2;
    }
    out.axis = delta.estimate(axis, by);
    return out;
}

}  // namespace vybeg
