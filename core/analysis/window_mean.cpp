#include "core/analysis/window_mean.h"

#include "core/numerics/dense_solvers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

// The polynomials orthogonal over the window up to an order, column by column, of size about 1.
Eigen::MatrixXd polynomials(const Eigen::VectorXd& u, Eigen::Index order) {
    Eigen::MatrixXd p(u.size(), order + 1);
    p.col(0).setOnes();
    for (Eigen::Index k = 0; k < order; ++k) {
        p.col(k + 1) = u.cwiseProduct(p.col(k));
        if (k > 0) {
            p.col(k + 1) -= p.col(k).squaredNorm() / p.col(k - 1).squaredNorm() * p.col(k - 1);
        }
    }
    return p;
}

Eigen::Index order_of(std::int64_t n, double w) {
    const double periods = static_cast<double>(n) * w / (2 * std::numbers::pi);
    return static_cast<Eigen::Index>(std::clamp(periods / 2, 2.0, 5.0));
}

}  // namespace

WindowMean::WindowMean(std::int64_t n, double w, std::span<const double> lines) {
    const double half = 0.5 * static_cast<double>(n);
    const Eigen::VectorXd j = Eigen::VectorXd::LinSpaced(n, 0.5 - half, half - 0.5);
    const Eigen::Index order = order_of(n, w);
    const Eigen::MatrixXd p = polynomials(j / half, order);
    // Lines that a short window cannot hold beside the rest are slopes there.
    const auto held = std::min<Eigen::Index>(std::ssize(lines), n / 32);
    Eigen::MatrixXd functions(n, 2 * (order + 1) + 2 + 2 * held);
    const Eigen::ArrayXd cosine = (w * j.array()).cos();
    const Eigen::ArrayXd sine = (w * j.array()).sin();
    for (Eigen::Index k = 0; k <= order; ++k) {
        functions.col(2 * k) = p.col(k).array() * cosine;
        functions.col(2 * k + 1) = p.col(k).array() * sine;
    }
    functions.col(2 * order + 2) = p.col(0);
    functions.col(2 * order + 3) = p.col(1);
    for (Eigen::Index k = 0; k < held; ++k) {
        const double line = lines[static_cast<std::size_t>(k)];
        functions.col(2 * order + 4 + 2 * k) = (line * j.array()).cos();
        functions.col(2 * order + 5 + 2 * k) = (line * j.array()).sin();
    }
    const Eigen::Index count = functions.cols();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(functions);
    basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(n, count);
    const Eigen::MatrixXd inverse =
        qr.matrixQR().topRows(count).triangularView<Eigen::Upper>().solve(
            Eigen::MatrixXd::Identity(count, count));
    mean_of_ = inverse.topRows(2);
    mean_of_.row(1) *= -1;
    sd_of_part_ = std::sqrt(mean_of_.squaredNorm() / 2);
    freedom_ = 2 * static_cast<double>(n - count);
}

WindowMean::Channel WindowMean::channel(std::span<const double> samples) const {
    const Eigen::Map<const Eigen::VectorXd> x(samples.data(), std::ssize(samples));
    const Eigen::VectorXd products = basis_.transpose() * x;
    const Eigen::Vector2d mean = mean_of_ * products;
    return {{mean[0], mean[1]}, products.squaredNorm()};
}

WindowMean::Estimate WindowMean::estimate(const Window& window) const {
    const SampleProducts products = sample_products(window);
    const Channel c = channel(window.c);
    const Channel d = channel(window.d);
    const double power = products.cc + products.dd;
    // The difference has lost its digits where the fit is almost perfect; nothing recorded is.
    const double residual = std::max(power - c.power - d.power, 1e-14 * power);
    return {{c.mean, d.mean},
            std::isfinite(power) ? residual / freedom() : std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace vybeg
