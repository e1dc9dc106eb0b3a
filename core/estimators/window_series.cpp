#include "core/estimators/window_series.h"

#include "core/estimators/lanes.h"
#include "core/estimators/window_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// Vectors are passed between inlined functions only: how they would be passed otherwise is nobody's
// concern.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace vybeg {
namespace {

constexpr int newton_steps = 6;

// p^2/g of one component, added to the power (profile.cpp has the same for one window).
VYBEG_INLINED inline void add_component(Bent& power, const Bent& p, const Bent& g) {
    const Eight ratio = p.value / g.value;
    const Eight ratio1 = (p.slope - ratio * g.slope) / g.value;
    power.value += p.value * ratio;
    power.slope += ratio * (2 * p.slope - ratio * g.slope);
    power.bend += 2 * ratio1 * (p.slope - ratio * g.slope) + ratio * (2 * p.bend - ratio * g.bend);
}

}  // namespace

SeriesBasis::SeriesBasis(std::int64_t n, double w0) : n_(n), w0_(w0) {
    const auto count = static_cast<double>(n);
    spread_ = count * (count * count - 1) / 12;
    if (n > longest_series_window) {
        return;
    }
    rows_.resize(static_cast<std::size_t>(n) * 2 * series_orders);
    for (std::int64_t j = 0; j < n; ++j) {
        const double u = static_cast<double>(j) - 0.5 * (count - 1);
        const double v = 2 * u / count;
        // cos and sin of w0 u + k pi/2.
        const std::array<double, 4> turned{std::cos(w0 * u), -std::sin(w0 * u), -std::cos(w0 * u),
                                           std::sin(w0 * u)};
        double factor = 1;
        double* row = rows_.data() + 2 * series_orders * static_cast<std::size_t>(j);
        for (std::size_t k = 0; k < series_orders; ++k) {
            row[k] = factor * turned[k % 4];
            row[series_orders + k] = factor * turned[(k + 3) % 4];
            factor *= v / static_cast<double>(k + 1);
        }
        // gram_cos = sum (1 + cos 2wu)/2, and 2wu = 2 w0 u + 2xv.
        const std::array<double, 4> doubled{std::cos(2 * w0 * u), -std::sin(2 * w0 * u),
                                            -std::cos(2 * w0 * u), std::sin(2 * w0 * u)};
        factor = 0.5;
        for (std::size_t k = 0; k < gram_orders; ++k) {
            gram_[k] += factor * doubled[k % 4];
            factor *= 2 * v / static_cast<double>(k + 1);
        }
    }
    gram_[0] += 0.5 * count;
}

WindowKernel SeriesBasis::kernel(double x) const {
    double value = 0;
    double slope = 0;
    double bend = 0;
    for (std::size_t k = gram_orders; k-- > 0;) {
        bend = bend * x + slope;
        slope = slope * x + value;
        value = value * x + gram_[k];
    }
    const double half = 0.5 * static_cast<double>(n_);  // dx/dw
    return {value, static_cast<double>(n_) - value, slope * half, 2 * bend * half * half, spread_};
}

VYBEG_DISPATCHED
void sum_series(const WindowBlock& block, std::size_t first, std::size_t count,
                const SeriesBasis& basis, SeriesBatch& batch) {
    for (std::size_t lane = 0; lane < count; ++lane) {
        const Window window = window_of(block, first + lane);
        Eight c_cos{};
        Eight c_sin{};
        Eight d_cos{};
        Eight d_sin{};
        SampleProducts sum;
        if (basis.length() > longest_series_window) {
            c_cos = c_sin = d_cos = d_sin = Eight{} + std::numeric_limits<double>::quiet_NaN();
            sum = sample_products(window);
        } else {
            const double* row = basis.row(0);
            for (std::size_t j = 0; j < window.c.size(); ++j, row += 2 * series_orders) {
                const double c = window.c[j];
                const double d = window.d[j];
                const Eight cosines = load(row);
                const Eight sines = load(row + series_orders);
                c_cos += c * cosines;
                c_sin += c * sines;
                d_cos += d * cosines;
                d_sin += d * sines;
                sum.cc += c * c;
                sum.dd += d * d;
                sum.cd += c * d;
            }
        }
        // The last window goes into the lanes beyond it, too.
        const std::size_t end = lane + 1 == count ? series_lanes : lane + 1;
        for (std::size_t to = lane; to < end; ++to) {
            for (std::size_t k = 0; k < series_orders; ++k) {
                batch.c_cos[k][to] = c_cos[k];
                batch.c_sin[k][to] = c_sin[k];
                batch.d_cos[k][to] = d_cos[k];
                batch.d_sin[k][to] = d_sin[k];
            }
            batch.cc[to] = sum.cc;
            batch.dd[to] = sum.dd;
            batch.cd[to] = sum.cd;
        }
    }
}

VYBEG_DISPATCHED
void maximise_series(const SeriesBatch& batch, const SeriesBasis& basis, SeriesMaximum& maximum) {
    const auto of = [](const std::array<Lanes, series_orders>& sums) {
        return [&sums](std::size_t k) VYBEG_INLINED { return load(sums[k]); };
    };
    const auto power_at = [&](Eight x) VYBEG_INLINED {
        const auto& gram = basis.gram();
        const Bent g_cos = series_at<SeriesBasis::gram_orders>(
            x, [&gram](std::size_t k) VYBEG_INLINED { return gram[k] + Eight{}; });
        const Bent g_sin{static_cast<double>(basis.length()) - g_cos.value, -g_cos.slope,
                         -g_cos.bend};
        Bent power{};
        add_component(power, series_at<series_orders>(x, of(batch.c_cos)), g_cos);
        add_component(power, series_at<series_orders>(x, of(batch.c_sin)), g_sin);
        add_component(power, series_at<series_orders>(x, of(batch.d_cos)), g_cos);
        add_component(power, series_at<series_orders>(x, of(batch.d_sin)), g_sin);
        return power;
    };
    Eight x{};
    Eight taken{};
    Eight good = x + 1;
    Eight last_move = x + 1;
    for (int step = 0; step < newton_steps; ++step) {
        const Bent power = power_at(x);
        const Eight move = -power.slope / power.bend;
        // A lane that has left stays where it was, and is not good.
        const Eight next = x + move;
        const auto inside =
            (next < series_reach) & (next > -series_reach) & (power.bend < 0) & (good > 0);
        good = inside ? good : Eight{};
        x = inside ? next : x;
        last_move = inside ? move : last_move;
        taken = power.value + 0.5 * power.slope * move;  // at `next`, to the third order
        // Convergence is quadratic: behind a move of 1e-6 is one of 1e-12 at most.
        const auto on_the_way = (good > 0) & ((last_move > 1e-6) | (last_move < -1e-6));
        bool any = false;
        for (std::size_t lane = 0; lane < series_lanes; ++lane) {
            any = any || on_the_way[lane] != 0;
        }
        if (!any) {
            break;
        }
    }
    store(x, maximum.x);
    store(taken, maximum.power);
    for (std::size_t lane = 0; lane < series_lanes; ++lane) {
        maximum.arrived[lane] = good[lane] > 0 && std::abs(last_move[lane]) < 1e-6 ? 1 : 0;
    }
}

Projections series_projections(const SeriesBatch& batch, std::size_t lane, double x) {
    const auto at = [lane, x](const std::array<Lanes, series_orders>& sums) {
        double value = 0;
        for (std::size_t k = series_orders; k-- > 0;) {
            value = value * x + sums[k][lane];
        }
        return value;
    };
    return {{at(batch.c_cos), -at(batch.c_sin)}, {at(batch.d_cos), -at(batch.d_sin)}};
}

}  // namespace vybeg
