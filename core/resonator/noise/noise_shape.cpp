#include "core/resonator/noise/noise_shape.h"

#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

// The mean of -ln|lag| over two windows whose centres are x windows apart, up to a constant.
double one_over_f(double x) {
    const auto g = [](double at) {
        const double square = at * at;
        return square > 0 ? 0.25 * square * std::log(square) - 0.75 * square : 0;
    };
    return 2 * g(x) - g(x + 1) - g(x - 1);
}

}  // namespace

Eigen::MatrixXd shape_covariance(const NoiseShape& shape, const std::vector<double>& time_s,
                                 double window_s) {
    const auto n = static_cast<Eigen::Index>(time_s.size());
    if (std::isinf(shape.half_width_hz)) {
        return Eigen::MatrixXd::Identity(n, n);
    }
    Eigen::MatrixXd covariance(n, n);
    const double rate = 2 * std::numbers::pi * shape.half_width_hz;
    const double turn = rate * window_s;
    const double apart = std::pow(std::sinh(turn / 2) / (turn / 2), 2);
    const double same = 2 * (turn + std::expm1(-turn)) / (turn * turn);
    const double constant = std::log(1 + static_cast<double>(n));
    for (Eigen::Index k = 0; k < n; ++k) {
        for (Eigen::Index l = 0; l <= k; ++l) {
            const double lag =
                time_s[static_cast<std::size_t>(k)] - time_s[static_cast<std::size_t>(l)];
            double value = 0;
            if (shape.half_width_hz == 0) {
                value = constant + one_over_f(lag / window_s);
            } else {
                value = lag < window_s / 2 ? same : apart * std::exp(-rate * lag);
            }
            covariance(k, l) = covariance(l, k) = value;
        }
    }
    return covariance;
}

}  // namespace vybeg
