#include "core/resonator/fit/delayed_pencil.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Vector2cd;
using Matrix = Eigen::Matrix2cd;

// Phasors in one stacked vector, enough to average the noise.
constexpr std::size_t stack = 8;
using Stacked = Eigen::Matrix<Complex, 2 * stack, 1>;

// Index of the window at each step from the start; -1 in a gap.
std::vector<std::ptrdiff_t> windows_by_step(const ScaledRun& run) {
    std::vector<std::ptrdiff_t> window;
    for (std::size_t k = 0; k < run.size(); ++k) {
        const auto step = static_cast<std::size_t>(
            std::lround((run.time_s[k] - run.time_s.front()) / run.step_s));
        window.resize(std::max(window.size(), step + 1), -1);
        window[step] = static_cast<std::ptrdiff_t>(k);
    }
    return window;
}

// z(t) = v1 e^{l1 t} + v2 e^{l2 t} in least squares; the columns are v1 and v2.
Matrix shapes(const ScaledRun& run, const std::vector<Vector2cd>& z, const Vector2cd& rates) {
    Matrix normal = Matrix::Zero();
    Matrix right = Matrix::Zero();
    for (std::size_t k = 0; k < run.size(); ++k) {
        const Vector2cd mode = (rates * run.time_s[k]).array().exp();
        normal += mode.conjugate() * mode.transpose();
        right += mode.conjugate() * z[k].transpose();
    }
    return (normal.inverse() * right).transpose();
}

}  // namespace

std::optional<SlowRates> delayed_pencil(const ScaledRun& run, const std::vector<Vector2cd>& z,
                                        std::size_t delay) {
    const std::vector<std::ptrdiff_t> window = windows_by_step(run);
    const std::size_t reach = (stack - 1) * delay + 1;
    std::vector<Stacked> vectors;
    std::vector<std::size_t> steps;
    for (std::size_t step = 0; step + reach <= window.size(); ++step) {
        Stacked vector;
        bool whole = true;
        for (std::size_t k = 0; k < stack && whole; ++k) {
            const std::ptrdiff_t at = window[step + k * delay];
            whole = at >= 0;
            if (whole) {
                vector.segment<2>(static_cast<Eigen::Index>(2 * k)) =
                    z[static_cast<std::size_t>(at)];
            }
        }
        if (whole) {
            vectors.push_back(vector);
            steps.push_back(step);
        }
    }
    if (vectors.size() < 2 * stack) {
        return std::nullopt;
    }
    Eigen::Matrix<Complex, 2 * stack, 2 * stack> power;
    power.setZero();
    for (const Stacked& vector : vectors) {
        power += vector * vector.adjoint();
    }
    const Eigen::SelfAdjointEigenSolver<decltype(power)> principal(power);
    const Eigen::Matrix<Complex, 2, 2 * stack> plane =
        principal.eigenvectors().rightCols<2>().adjoint();
    Matrix late = Matrix::Zero();
    Matrix early = Matrix::Zero();
    for (std::size_t k = 0; k + 1 < vectors.size(); ++k) {
        if (steps[k + 1] == steps[k] + 1) {
            const Vector2cd now = plane * vectors[k];
            late += plane * vectors[k + 1] * now.adjoint();
            early += now * now.adjoint();
        }
    }
    const Vector2cd rates = eigenvalues_of(late * early.inverse()).array().log() / run.step_s;
    if (!rates.allFinite()) {
        return std::nullopt;
    }
    const Matrix v = shapes(run, z, rates);
    // Columns of unit length: the determinant is the sine of the angle between the shapes.
    if (!(std::abs(v.determinant()) > 1e-6 * v.col(0).norm() * v.col(1).norm())) {
        return std::nullopt;
    }
    return rates_of(Matrix(v * rates.asDiagonal() * v.inverse()));
}

}  // namespace vybeg
