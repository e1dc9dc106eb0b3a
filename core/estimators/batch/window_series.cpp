#include "core/estimators/batch/window_series.h"

#include "core/estimators/batch/lanes.h"

#include <cmath>

// Vectors are passed between inlined functions only: how they would be passed otherwise is nobody's
// concern.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace vybeg {
namespace {

constexpr int newton_steps = 6;

// p^2/g of one component, added to the power; by_g = 1/g. (profile.cpp has the same for one
// window.)
VYBEG_INLINED inline void add_component(Bent& power, const Bent& p, const Bent& g, Eight by_g) {
    const Eight ratio = p.value * by_g;
    const Eight left = p.slope - ratio * g.slope;
    power.value += p.value * ratio;
    power.slope += ratio * (p.slope + left);
    power.bend += 2 * (left * left) * by_g + ratio * (2 * p.bend - ratio * g.bend);
}

// gram_cos = (n + D)/2 as a series in x, D sin w = sin nw with w = w0 + 2x/n: a quotient of two
// series.
std::array<double, SeriesFrame::gram_orders> gram_series(std::int64_t n, double w0) {
    constexpr std::size_t orders = SeriesFrame::gram_orders;
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

SeriesFrame::SeriesFrame(std::int64_t n, double w0) : n_(n), w0_(w0), gram_(gram_series(n, w0)) {
    const auto count = static_cast<double>(n);
    spread_ = count * (count * count - 1) / 12;
}

SeriesBasis::SeriesBasis(std::int64_t n, double w0)
    : SeriesFrame(n, w0),
      stretch_(n <= longest_whole_window ? n : stretch_length),
      rows_(static_cast<std::size_t>(stretch_) * 2 * series_orders) {
    const auto count = static_cast<double>(n);
    // Rows as far before the middle as behind it differ in signs alone: cos is even, sin odd, and
    // order k has v^k and a turn by k quarters.
    for (std::int64_t j = stretch_ / 2; j < stretch_; ++j) {
        const double u = static_cast<double>(j) - 0.5 * static_cast<double>(stretch_ - 1);
        const double v = 2 * u / count;
        const double cosine = std::cos(w0 * u);
        const double sine = std::sin(w0 * u);
        // cos and sin of w0 u + k pi/2.
        const std::array<double, 4> turned{cosine, -sine, -cosine, sine};
        double factor = 1;
        double* row = rows_.data() + 2 * series_orders * static_cast<std::size_t>(j);
        double* mirrored =
            rows_.data() + 2 * series_orders * static_cast<std::size_t>(stretch_ - 1 - j);
        for (std::size_t k = 0; k < series_orders; ++k) {
            row[k] = factor * turned[k % 4];
            row[series_orders + k] = factor * turned[(k + 3) % 4];
            mirrored[k] = row[k];
            mirrored[series_orders + k] = -row[series_orders + k];
            factor *= v / static_cast<double>(k + 1);
        }
    }
}

WindowKernel SeriesFrame::kernel(double x) const {
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
void maximise_series(const SeriesBatch& batch, const SeriesFrame& frame, SeriesMaximum& maximum) {
    const auto power_of = [&](const auto& at, const auto& gram_at) VYBEG_INLINED {
        const Bent g_cos = gram_at();
        const Bent g_sin{static_cast<double>(frame.length()) - g_cos.value, -g_cos.slope,
                         -g_cos.bend};
        const Eight by_cos = 1 / g_cos.value;
        const Eight by_sin = 1 / g_sin.value;
        Bent power{};
        add_component(power, at(batch.c_cos), g_cos, by_cos);
        add_component(power, at(batch.c_sin), g_sin, by_sin);
        add_component(power, at(batch.d_cos), g_cos, by_cos);
        add_component(power, at(batch.d_sin), g_sin, by_sin);
        return power;
    };
    const auto& gram = frame.gram();
    // At the carrier the series are their first coefficients.
    Bent power = power_of(
        [](const auto& sums) VYBEG_INLINED {
            return Bent{load(sums[0]), load(sums[1]), 2 * load(sums[2])};
        },
        [&]() VYBEG_INLINED {
            return Bent{gram[0] + Eight{}, gram[1] + Eight{}, 2 * gram[2] + Eight{}};
        });
    Eight x{};
    Eight taken{};
    Eight good = x + 1;  // or 0
    Eight last_move = x + 1;
    for (int step = 0;; ++step) {
        const Eight move = -power.slope / power.bend;
        // A lane that has left stays where it was, and is not good. A step that is NaN leaves.
        const Eight next = x + move;
        good = if_negative(power.bend, good, Eight{});
        good = if_negative(absolute(next) - series_reach, good, Eight{});
        x = if_negative(0.5 - good, next, x);
        last_move = if_negative(0.5 - good, move, last_move);
        taken = power.value + 0.5 * power.slope * move;  // at `next`, to the third order
        // Convergence is quadratic: behind a move of 1e-6 is one of 1e-12 at most.
        const Eight on_the_way = if_negative(absolute(last_move) - 1e-6, Eight{}, good);
        if (total(on_the_way) == 0 || step == newton_steps) {
            store(good - on_the_way, maximum.arrived);
            break;
        }
        power = power_of(
            [x](const auto& sums) VYBEG_INLINED {
                return series_at<series_orders>(
                    x, [&sums](std::size_t k) VYBEG_INLINED { return load(sums[k]); });
            },
            [&]() VYBEG_INLINED {
                return series_at<SeriesFrame::gram_orders>(
                    x, [&gram](std::size_t k) VYBEG_INLINED { return gram[k] + Eight{}; });
            });
    }
    store(x, maximum.x);
    store(taken, maximum.power);
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
