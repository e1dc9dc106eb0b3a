#include "core/resonator/identifiability.h"

#include "core/estimators/wave_state.h"
#include "core/resonator/wave_angle.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

using std::numbers::pi;

}  // namespace

Sight sight(const Eigen::MatrixXd& covariance) {
    // split cos, split sin, damping cos, damping sin, rotation, decay.
    constexpr std::array<int, 6> rate{0, 1, 2, 3, 4, 6};
    constexpr std::array<double, 6> unit{pi, pi, 0.5, 0.5, 1, 1};
    Eigen::Matrix<double, 6, 6> c;
    for (std::size_t j = 0; j < 6; ++j) {
        for (std::size_t k = 0; k < 6; ++k) {
            c(static_cast<int>(j), static_cast<int>(k)) =
                unit[j] * unit[k] * covariance(rate[j], rate[k]);
        }
    }
    const auto extremes = [](const auto& matrix) {
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix, Eigen::EigenvaluesOnly);
        const auto& values = eigen.eigenvalues();
        return std::pair(std::sqrt(std::max(values[0], 0.0)), std::sqrt(values[values.size() - 1]));
    };
    return {.best = extremes(c).first,
            .split = extremes(c.topLeftCorner<2, 2>()).second,
            .damping = extremes(c.block<2, 2>(2, 2)).second,
            .rotation = std::sqrt(c(4, 4))};
}

double split_size(const Shared& shared) {
    return pi * std::hypot(shared[0], shared[1]);
}

double damping_size(const Shared& shared) {
    return 0.5 * std::hypot(shared[2], shared[3]);
}

bool significant(double fall, int parameters) {
    const double n = parameters;
    const double root = 1 - 2 / (9 * n) + 4 * std::sqrt(2 / (9 * n));
    return fall > n * root * root * root;
}

Eigen::Vector2d seen_direction(const FitState& state) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (const Own& own : state.runs) {
        const Eigen::Vector2cd z = start_of(own);
        const double four_theta = 2 * to_wave_state({z[0], z[1]}).two_theta_A;
        const Eigen::Vector2d seen(std::sin(four_theta), -std::cos(four_theta));
        sum += z.squaredNorm() * seen * seen.transpose();
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(sum).eigenvectors().col(1);
}

double turned_deg(std::span<const ScaledRun> runs) {
    double most = 0;
    for (const ScaledRun& run : runs) {
        const auto [low, high] = std::ranges::minmax(wave_angle(run).two_theta);
        most = std::max(most, (high - low) / 2 * 180 / pi);
    }
    return most;
}

}  // namespace vybeg
