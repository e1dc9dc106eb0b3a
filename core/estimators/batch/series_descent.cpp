#include "core/estimators/batch/series_descent.h"

#include "core/estimators/batch/lanes.h"
#include "core/estimators/batch/series_waves.h"
#include "core/estimators/wave/descent.h"
#include "core/estimators/wave/wave_functional.h"

#include <cmath>
#include <numbers>

// As in lanes.h.
#pragma GCC diagnostic ignored "-Wpsabi"

// As atan2 in series_waves.h.
#ifndef __clang__
extern "C" {
__attribute__((simd("notinbranch"), const)) double sin(double x) noexcept;
}
#endif

namespace vybeg {
namespace {

// Most windows need 5 to 10; the few that need more are as well estimated by themselves.
constexpr int most_steps = 40;

using Five = std::array<Eight, 5>;  // by a_A, a_B, 2theta_A, alpha, x

VYBEG_INLINED inline Eight dot(const Five& a, const Five& b) {
    Eight sum = a[0] * b[0];
    for (std::size_t k = 1; k < 5; ++k) {
        sum += a[k] * b[k];
    }
    return sum;
}

VYBEG_INLINED inline Five times(const std::array<Five, 5>& matrix, const Five& vector) {
    Five product;
    for (std::size_t k = 0; k < 5; ++k) {
        product[k] = dot(matrix[k], vector);
    }
    return product;
}

// All cosines and sines in one loop, the cosines as sines: of both of the same number GCC would
// make one call for each lane.
VYBEG_INLINED inline TurnedWave<Eight> turned(const Five& at) {
    constexpr double quarter = std::numbers::pi / 2;
    const std::array<Eight, 4> phases{at[2] + quarter, at[2], at[3] + quarter, at[3]};
    std::array<double, 4 * series_lanes> sines;
    __builtin_memcpy(sines.data(), phases.data(), sizeof sines);
    for (double& sine : sines) {
        sine = ::sin(sine);
    }
    const auto sine = [&](std::size_t k)
                          VYBEG_INLINED { return load(sines.data() + k * series_lanes); };
    return {at[0], at[1], sine(0), sine(1), sine(2), sine(3)};
}

VYBEG_INLINED inline WaveFunctional<Eight> functional_at(const SeriesBatch& batch,
                                                         const SeriesFrame& frame, const Five& at) {
    const Eight x = at[4];
    const auto bent = [x](const std::array<Lanes, series_orders>& sums) VYBEG_INLINED {
        return series_at<series_orders>(x,
                                        [&](std::size_t k) VYBEG_INLINED { return load(sums[k]); });
    };
    const auto jet = [&](const std::array<Lanes, series_orders>& cosines,
                         const std::array<Lanes, series_orders>& sines) VYBEG_INLINED {
        const Bent re = bent(cosines);
        const Bent im = bent(sines);
        return ComplexJet<Eight>{{re.value, re.slope, re.bend}, {-im.value, -im.slope, -im.bend}};
    };
    const auto n = static_cast<double>(frame.length());
    const Bent gram = gram_at(frame, x);
    return wave_functional<Eight>(turned(at), jet(batch.c_cos, batch.c_sin),
                                  jet(batch.d_cos, batch.d_sin),
                                  {2 * gram.value - n, 2 * gram.slope, 2 * gram.bend}, n);
}

// The Hessian of an ideal window, inverted: as in conjugate_gradient.cpp.
struct Preconditioner {
    double amplitude;
    Eight same;
    Eight cross;
    Eight frequency;

    VYBEG_INLINED Preconditioner(const Five& at, const SeriesFrame& frame) {
        const auto n = static_cast<double>(frame.length());
        const Eight power = at[0] * at[0] + at[1] * at[1];
        const Eight most = 0.999 * power;
        Eight product = 2 * at[0] * at[1];
        product = if_negative(most - product, most, product);
        product = if_negative(product + most, -most, product);
        const Eight by_determinant = 1 / (power * power - product * product);
        amplitude = 1 / n;
        same = amplitude * power * by_determinant;
        cross = amplitude * product * by_determinant;
        frequency = 0.25 * n * n / (power * frame.spread());
    }

    VYBEG_INLINED Five apply(const Five& g) const {
        return {amplitude * g[0], amplitude * g[1], same * g[2] + cross * g[3],
                cross * g[2] + same * g[3], frequency * g[4]};
    }
};

// 1 where the matrix is positive definite, by the pivots of its elimination; else 0.
VYBEG_INLINED inline Eight is_positive(std::array<Five, 5> h) {
    Eight positive = Eight{} + 1.0;
    for (std::size_t k = 0; k < 5; ++k) {
        positive = if_negative(-h[k][k], positive, Eight{});
        const Eight by_pivot = 1 / h[k][k];
        for (std::size_t row = k + 1; row < 5; ++row) {
            const Eight factor = h[row][k] * by_pivot;
            for (std::size_t column = k + 1; column < 5; ++column) {
                h[row][column] -= factor * h[k][column];
            }
        }
    }
    return positive;
}

VYBEG_INLINED inline Eight power_of(const Five& at) {
    return at[0] * at[0] + at[1] * at[1];
}

}  // namespace

VYBEG_DISPATCHED
void in_phase_starts(const SeriesBatch& __restrict batch, const SeriesFrame& __restrict frame,
                     SeriesStart& __restrict start) {
    const auto n = static_cast<double>(frame.length());
    const Eight cc = load(batch.cc);
    const Eight dd = load(batch.dd);
    const Eight cosine = sqrt_of(cc);
    const Eight sine = if_negative(load(batch.cd), -sqrt_of(dd), sqrt_of(dd));
    const Eight p = load(batch.c_cos[0]) * cosine + load(batch.d_cos[0]) * sine;
    const Eight q = load(batch.c_sin[0]) * cosine + load(batch.d_sin[0]) * sine;
    store(sqrt_of(2 / n * (cc + dd)), start.a_A);
    store(Eight{}, start.a_B);
    store(atan2_of(sine, cosine), start.two_theta_A);
    store(atan2_of(q, p), start.alpha);
    store(Eight{}, start.x);
}

VYBEG_DISPATCHED
void descend_series(const SeriesBatch& __restrict batch, const SeriesFrame& __restrict frame,
                    const SeriesStart& __restrict start, SeriesDescent& __restrict descent) {
    const auto n = static_cast<double>(frame.length());
    const double tolerance = descent_tolerance(frame.w0(), frame.length());
    Five at{load(start.a_A), load(start.a_B), load(start.two_theta_A), load(start.alpha),
            load(start.x)};
    Eight good = if_negative(absolute(at[4]) - series_reach, Eight{} + 1.0, Eight{});
    Eight on_the_way = good;
    WaveFunctional<Eight> f = functional_at(batch, frame, at);
    Preconditioner scale(at, frame);
    Five direction{};
    for (int steps = 0; steps < most_steps; ++steps) {
        if (steps % descent_restart == 0) {
            scale = Preconditioner(at, frame);
            direction = {};
        }
        const Five scaled = scale.apply(f.gradient);
        const Eight left = dot(f.gradient, scaled);
        on_the_way = if_negative(left - tolerance * tolerance * n * power_of(at), Eight{}, good);
        if (total(on_the_way) == 0) {
            break;
        }
        const Five bent = times(f.hessian, direction);
        const Eight before = dot(direction, bent);
        constexpr double least = 1e-300;
        const Eight beta = if_negative(least - before, dot(scaled, bent) / before, Eight{});
        Five next;
        for (std::size_t k = 0; k < 5; ++k) {
            next[k] = beta * direction[k] - scaled[k];
        }
        const Eight uphill = dot(f.gradient, next);
        for (std::size_t k = 0; k < 5; ++k) {
            direction[k] = if_negative(uphill, next[k], -scaled[k]);
        }
        const Eight slope = dot(f.gradient, direction);
        const Eight curvature = dot(direction, times(f.hessian, direction));
        const Eight step = -slope / curvature;
        Five there;
        for (std::size_t k = 0; k < 5; ++k) {
            // Windows that have arrived stay.
            there[k] = if_negative(0.5 - on_the_way, at[k] + step * direction[k], at[k]);
        }
        f = [&]() VYBEG_INLINED {
            const Eight value = f.value;
            const WaveFunctional<Eight> found = functional_at(batch, frame, there);
            const Eight rounding = 1e-14 * (absolute(value) + absolute(slope * step));
            const Eight too_high = found.value - (value + 1e-4 * step * slope + rounding);
            Eight taken = if_negative(-curvature, good, Eight{});
            taken = if_negative(absolute(there[4]) - series_reach, taken, Eight{});
            taken = if_negative(too_high, taken, Eight{});
            good = if_negative(0.5 - on_the_way, taken, good);
            return found;
        }();
        at = there;
    }
    const Eight minimum = is_positive(f.hessian);
    store(if_negative(0.5 - on_the_way, Eight{}, good * minimum), descent.arrived);
    store(load(batch.cc) + load(batch.dd) + f.value, descent.residual);

    const TurnedWave<Eight> wave = turned(at);
    // e^{-i alpha} (a_A cos + i a_B sin) and so on, METHOD section 1.
    const auto phasor = [&](Eight re, Eight im) VYBEG_INLINED {
        return std::array<Eight, 2>{wave.cos_phase * re + wave.sin_phase * im,
                                    wave.cos_phase * im - wave.sin_phase * re};
    };
    const auto c = phasor(wave.a_A * wave.cos_angle, wave.a_B * wave.sin_angle);
    const auto d = phasor(wave.a_A * wave.sin_angle, -wave.a_B * wave.cos_angle);
    const PhasorLanes phasors{c[0], c[1], d[0], d[1]};
    complete_lanes(batch, frame, at[4], gram_at(frame, at[4]), phasors, state_of(phasors),
                   descent.waves);
}

}  // namespace vybeg
