#include "core/estimators/batch/taylor_window.h"

#include "core/estimators/wave/jet.h"

#include <cmath>

namespace vybeg {
namespace {

// gram_cos = (n + D)/2 as a series in x, D sin w = sin nw with w = w0 + 2x/n: a quotient of two
// series.
std::array<double, TaylorFrame::gram_orders> gram_series(std::int64_t n, double w0) {
    constexpr std::size_t orders = TaylorFrame::gram_orders;
    const auto count = static_cast<double>(n);
    // The series of sin(at + x step).
    const auto sine = [](double at, double step) {
        const std::array<double, 4> turned{std::sin(at), std::cos(at), -std::sin(at),
                                           -std::cos(at)};
        std::array<double, orders> series{};
        double factor = 1;
        for (std::size_t k = 0; k < orders; ++k) {
            series[k] = factor * turned[k % 4];
            factor *= step / static_cast<double>(k + 1);
        }
        return series;
    };
    const std::array<double, orders> above = sine(count * w0, 2);
    const std::array<double, orders> below = sine(w0, 2 / count);
    std::array<double, orders> gram{};
    for (std::size_t k = 0; k < orders; ++k) {
        double rest = above[k];
        for (std::size_t j = 1; j <= k; ++j) {
            rest -= below[j] * gram[k - j];
        }
        gram[k] = rest / below[0];
    }
    gram[0] += count;
    for (double& coefficient : gram) {
        coefficient *= 0.5;
    }
    return gram;
}

}  // namespace

TaylorFrame::TaylorFrame(std::int64_t n, double w0) : n_(n), w0_(w0), gram_(gram_series(n, w0)) {
    const auto count = static_cast<double>(n);
    spread_ = count * (count * count - 1) / 12;
}

TaylorBasis::TaylorBasis(std::int64_t n, double w0)
    : TaylorFrame(n, w0),
      segment_(n <= longest_whole_window ? n : segment_length),
      rows_(static_cast<std::size_t>(segment_) * 2 * taylor_orders) {
    const auto count = static_cast<double>(n);
    // Rows at equal distances before and after the centre differ in sign only: cos is even, sin
    // odd, and order k has v^k and a rotation by k quarter turns.
    for (std::int64_t j = segment_ / 2; j < segment_; ++j) {
        const double u = static_cast<double>(j) - 0.5 * static_cast<double>(segment_ - 1);
        const double v = 2 * u / count;
        const double cosine = std::cos(w0 * u);
        const double sine = std::sin(w0 * u);
        // cos and sin of w0 u + k pi/2.
        const std::array<double, 4> turned{cosine, -sine, -cosine, sine};
        double factor = 1;
        double* row = rows_.data() + 2 * taylor_orders * static_cast<std::size_t>(j);
        double* mirrored =
            rows_.data() + 2 * taylor_orders * static_cast<std::size_t>(segment_ - 1 - j);
        for (std::size_t k = 0; k < taylor_orders; ++k) {
            row[k] = factor * turned[k % 4];
            row[taylor_orders + k] = factor * turned[(k + 3) % 4];
            mirrored[k] = row[k];
            mirrored[taylor_orders + k] = -row[taylor_orders + k];
            factor *= v / static_cast<double>(k + 1);
        }
    }
}

WindowKernel TaylorFrame::kernel(double x) const {
    const Jet2<double> g =
        polynomial_jet<gram_orders>(x, [this](std::size_t k) { return gram_[k]; });
    const double half = 0.5 * static_cast<double>(n_);  // dx/dw
    return {g.value, static_cast<double>(n_) - g.value, g.slope * half, g.bend * half * half,
            spread_};
}

Phasors lane_projections(const ProjectionBatch& batch, std::size_t lane, double x) {
    const auto at = [lane, x](const TaylorSums& sums) {
        return polynomial<taylor_orders>(x, [&](std::size_t k) { return sums[k][lane]; });
    };
    return {{at(batch.c_cos), -at(batch.c_sin)}, {at(batch.d_cos), -at(batch.d_sin)}};
}

}  // namespace vybeg
