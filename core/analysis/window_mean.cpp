#include "core/analysis/window_mean.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace vybeg {

WindowMean::WindowMean(std::int64_t n, double w) : n_(n), w_(w) {
    const auto count = static_cast<double>(n);
    mean_square_ = (count * count - 1) / 12;
    const double half = 0.5 * count;
    Eigen::Matrix3d even = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d odd = Eigen::Matrix3d::Zero();
    for (std::int64_t j = 0; j < n; ++j) {
        const double u = static_cast<double>(j) - 0.5 * (count - 1);
        const double p1 = u / half;
        const double p2 = (u * u - mean_square_) / (half * half);
        const double cosine = std::cos(w * u);
        const double sine = std::sin(w * u);
        const Eigen::Vector3d e{cosine, p1 * sine, p2 * cosine};
        const Eigen::Vector3d o{sine, p1 * cosine, p2 * sine};
        even += e * e.transpose();
        odd += o * o.transpose();
    }
    even_ = even.inverse();
    odd_ = odd.inverse();
    sd_of_part_ = std::sqrt((even_(0, 0) + odd_(0, 0)) / 2);
}

WindowMean::Channel WindowMean::channel(const ChannelMoments& moments) const {
    const double half = 0.5 * static_cast<double>(n_);
    const std::complex<double> z1 = moments[1] / half;
    const std::complex<double> z2 = (moments[2] - mean_square_ * moments[0]) / (half * half);
    const Eigen::Vector3d e{moments[0].real(), -z1.imag(), z2.real()};
    const Eigen::Vector3d o{-moments[0].imag(), z1.real(), -z2.imag()};
    const Eigen::Vector3d even = even_ * e;
    const Eigen::Vector3d odd = odd_ * o;
    return {{even[0], -odd[0]}, e.dot(even) + o.dot(odd)};
}

WindowMean::Estimate WindowMean::estimate(const Window& window) const {
    const Moments moments = window_moments(window, w_);
    const SampleProducts products = sample_products(window);
    const Channel c = channel(moments.c);
    const Channel d = channel(moments.d);
    const double power = products.cc + products.dd;
    // The difference has lost its digits where the fit is almost perfect; nothing recorded is.
    const double residual = std::max(power - c.power - d.power, 1e-14 * power);
    return {{c.mean, d.mean},
            std::isfinite(power) ? residual / freedom() : std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace vybeg
