#include "core/estimators/batch/descent.h"

#include "core/estimators/batch/closed_forms.h"
#include "core/estimators/wave/wave_formulas.h"

#include <algorithm>
#include <cstdint>
#include <numbers>

namespace vybeg {
namespace {

// Seen along the wave's axes and in its phase the projections Z = sum s e^{-iwu} of both signals
// are
//     A = e^{i alpha} (Z_C cos 2theta + Z_D sin 2theta)
//     B = e^{i alpha} (Z_D cos 2theta - Z_C sin 2theta)
// and, with D = sum cos 2wu, n F less the power of the samples is
//     n/2 (a_A^2 + a_B^2) + D/2 cos 2alpha (a_A^2 - a_B^2) - 2 a_A Re A + 2 a_B Im B.
// dA/d2theta = B, dB/d2theta = -A, d/dalpha = i of both, which yields all derivatives,
// those by the frequency in the unit of the jets.
template <class Real>
VYBEG_INLINED inline WaveFunctional<Real> wave_functional(const TurnedWave<Real>& wave,
                                                          const WindowJets<Real>& s, double n) {
    const Real a = wave.a_A;
    const Real b = wave.a_B;
    struct Turned {
        Jet2<Real> re;
        Jet2<Real> im;
    };
    const auto turned = [&](const Jet2<Real>& re, const Jet2<Real>& im) VYBEG_INLINED {
        return Turned{wave.cos_phase * re - wave.sin_phase * im,
                      wave.cos_phase * im + wave.sin_phase * re};
    };
    // Z = p - iq.
    const Turned A = turned(wave.cos_angle * s.pc + wave.sin_angle * s.pd,
                            -(wave.cos_angle * s.qc + wave.sin_angle * s.qd));
    const Turned B = turned(wave.cos_angle * s.pd - wave.sin_angle * s.pc,
                            -(wave.cos_angle * s.qd - wave.sin_angle * s.qc));
    const Jet2<Real> dirichlet{2 * s.g.value - n, 2 * s.g.slope, 2 * s.g.bend};
    const Real cosine = wave.cos_phase * wave.cos_phase - wave.sin_phase * wave.sin_phase;
    const Real sine = 2.0 * wave.sin_phase * wave.cos_phase;
    const Real dc = dirichlet.value * cosine;
    const Real ds = dirichlet.value * sine;
    const Real dc1 = dirichlet.slope * cosine;
    const Real difference = a * a - b * b;

    WaveFunctional<Real> f;
    f.value =
        0.5 * (n * (a * a + b * b) + dc * difference) - 2.0 * (a * A.re.value - b * B.im.value);
    f.gradient = {(n + dc) * a - 2.0 * A.re.value, (n - dc) * b + 2.0 * B.im.value,
                  -2.0 * (a * B.re.value + b * A.im.value),
                  2.0 * (a * A.im.value + b * B.re.value) - ds * difference,
                  0.5 * dc1 * difference - 2.0 * (a * A.re.slope - b * B.im.slope)};
    auto& h = f.hessian;
    const Real turning = 2.0 * (a * A.re.value - b * B.im.value);
    h[0] = {n + dc, Real{}, -2.0 * B.re.value, 2.0 * (A.im.value - ds * a),
            dc1 * a - 2.0 * A.re.slope};
    h[1] = {Real{}, n - dc, -2.0 * A.im.value, 2.0 * (B.re.value + ds * b),
            2.0 * B.im.slope - dc1 * b};
    h[2] = {h[0][2], h[1][2], turning, 2.0 * (a * B.im.value - b * A.re.value),
            -2.0 * (a * B.re.slope + b * A.im.slope)};
    h[3] = {h[0][3], h[1][3], h[2][3], turning - 2.0 * dc * difference,
            2.0 * (a * A.im.slope + b * B.re.slope) - dirichlet.slope * sine * difference};
    h[4] = {h[0][4], h[1][4], h[2][4], h[3][4],
            0.5 * dirichlet.bend * cosine * difference - 2.0 * (a * A.re.bend - b * B.im.bend)};
    return f;
}

// Tolerance of convergence: change of the samples by a Newton-like step relative to the wave. The
// last digit of w moves the ends of a long window by more than 1e-13.
double descent_tolerance(double w, std::int64_t n) {
    return 1e-13 + 6e-17 * w * static_cast<double>(n);
}

// Directions restart after as many steps as there are parameters.
constexpr int descent_restart = 5;

template <class Real>
VYBEG_INLINED inline Real dot(const Five<Real>& a, const Five<Real>& b) {
    Real sum = a[0] * b[0];
    for (std::size_t k = 1; k < 5; ++k) {
        sum += a[k] * b[k];
    }
    return sum;
}

template <class Real>
VYBEG_INLINED inline Five<Real> times(const std::array<Five<Real>, 5>& matrix,
                                      const Five<Real>& vector) {
    Five<Real> product;
    for (std::size_t k = 0; k < 5; ++k) {
        product[k] = dot(matrix[k], vector);
    }
    return product;
}

template <class Real>
VYBEG_INLINED inline Five<Real> moved(const Five<Real>& from, const Five<Real>& direction,
                                      Real step) {
    Five<Real> to;
    for (std::size_t k = 0; k < 5; ++k) {
        to[k] = from[k] + step * direction[k];
    }
    return to;
}

// Whether a symmetric matrix is positive definite, by the pivots of its elimination.
template <class Real>
VYBEG_INLINED inline MaskOf<Real> is_positive(std::array<Five<Real>, 5> h) {
    MaskOf<Real> positive = less(Real{}, 1.0);
    for (std::size_t k = 0; k < 5; ++k) {
        positive = positive & negative(-h[k][k]);
        const Real by_pivot = 1 / h[k][k];
        for (std::size_t row = k + 1; row < 5; ++row) {
            const Real factor = h[row][k] * by_pivot;
            for (std::size_t column = k + 1; column < 5; ++column) {
                h[row][column] -= factor * h[k][column];
            }
        }
    }
    return positive;
}

// a_A^2 + a_B^2.
template <class Real>
VYBEG_INLINED inline Real power_of(const Five<Real>& at) {
    return at[0] * at[0] + at[1] * at[1];
}

// Inverse Hessian of F in an ideal window without noise: the natural scale of each parameter. The
// quadrature wave couples angle and phase; at a_A = |a_B| the coupling is total and is limited to
// just below.
template <class Real>
struct Preconditioner {
    double amplitude;
    Real same;
    Real cross;
    Real frequency;

    // `spread` is that of the window's kernel; `unit` frequency units are one radian per sample.
    VYBEG_INLINED Preconditioner(const Five<Real>& at, double n, double spread, double unit) {
        const Real power = power_of(at);
        const Real most = 0.999 * power;
        Real product = 2 * at[0] * at[1];
        product = select(less(most, product), most, product);
        product = select(less(product, -most), -most, product);
        const Real by_determinant = 1 / (power * power - product * product);
        amplitude = 1 / n;
        same = amplitude * power * by_determinant;
        cross = amplitude * product * by_determinant;
        frequency = unit * unit / (power * spread);
    }

    VYBEG_INLINED Five<Real> apply(const Five<Real>& g) const {
        return {amplitude * g[0], amplitude * g[1], same * g[2] + cross * g[3],
                cross * g[2] + same * g[3], frequency * g[4]};
    }
};

// Next direction, conjugate to the one before with respect to the present Hessian; -scaled, the
// preconditioned gradient, if the conjugate direction ascends.
template <class Real>
struct DescentWay {
    Five<Real> direction;
    Real slope;
    Real curvature;
};
template <class Real>
VYBEG_INLINED inline DescentWay<Real> next_way(const WaveFunctional<Real>& f,
                                               const Five<Real>& scaled, const Five<Real>& before) {
    constexpr double least = 1e-300;
    const Five<Real> bent = times(f.hessian, before);
    const Real curvature = dot(before, bent);
    const Real beta = select(less(least, curvature), dot(scaled, bent) / curvature, Real{});
    DescentWay<Real> way;
    for (std::size_t k = 0; k < 5; ++k) {
        way.direction[k] = beta * before[k] - scaled[k];
    }
    const MaskOf<Real> downhill = negative(dot(f.gradient, way.direction));
    for (std::size_t k = 0; k < 5; ++k) {
        way.direction[k] = select(downhill, way.direction[k], -scaled[k]);
    }
    way.slope = dot(f.gradient, way.direction);
    way.curvature = dot(way.direction, times(f.hessian, way.direction));
    return way;
}

// Excess of F over the level that a step must reach. Rounding limits F, a difference of sums of
// squares.
template <class Real>
VYBEG_INLINED inline Real excess_of(Real there, Real here, Real step, Real slope) {
    const Real rounding = 1e-14 * (absolute(here) + absolute(slope * step));
    return there - (here + 1e-4 * step * slope + rounding);
}

constexpr int most_window_steps = 200;
// Most windows need 5 to 10 steps; the few that need more are estimated one by one.
constexpr int most_descent_steps = 40;

// All cosines and sines in one loop, with cosines computed as sines, because GCC combines cos and
// sin of one number into one call per lane.
VYBEG_INLINED inline TurnedWave<Vec8> turned_lanes(const Five<Vec8>& at) {
    constexpr double quarter = std::numbers::pi / 2;
    const std::array<Vec8, 4> phases{at[2] + quarter, at[2], at[3] + quarter, at[3]};
    std::array<double, 4 * lane_count> sines;
    __builtin_memcpy(sines.data(), phases.data(), sizeof sines);
    for (double& sine : sines) {
        sine = vybeg_sin(sine);
    }
    const auto sine = [&](std::size_t k)
                          VYBEG_INLINED { return load(sines.data() + k * lane_count); };
    return {at[0], at[1], sine(0), sine(1), sine(2), sine(3)};
}

VYBEG_INLINED inline WaveFunctional<Vec8> functional_at(const ProjectionBatch& batch,
                                                        const TaylorFrame& frame,
                                                        const Five<Vec8>& at) {
    return wave_functional(turned_lanes(at), jets_at(batch, frame, at[4]),
                           static_cast<double>(frame.length()));
}

}  // namespace

WaveFunctional<double> functional_at(const Window& window, const Five<double>& at) {
    const WindowKernel kernel = window_kernel(window.length(), at[4]);
    return wave_functional(turned({at[0], at[1], at[2], at[3]}),
                           jets_of(window_moments(window, at[4]), kernel),
                           kernel.gram_cos + kernel.gram_sin);
}

Five<double> in_phase_start(const Window& window, double w) {
    const std::int64_t n = window.length();
    const WindowJets<double> jets = jets_of(window_projections(window, w), window_kernel(n, w));
    const InPhaseForm<double> form(sample_products(window), {static_cast<double>(n)});
    return five_of(form.at(jets, 0).wave.wave, w);
}

Descent descend(const Window& window, const FrequencyBracket& bracket, const Five<double>& start) {
    const std::int64_t length = window.length();
    const auto n = static_cast<double>(length);
    const double edge = 1e-6 * (bracket.high - bracket.low);
    Five<double> at = start;
    at[4] = std::clamp(start[4], bracket.low + edge, bracket.high - edge);
    const double tolerance = descent_tolerance(at[4], length);
    const double spread = window_kernel(length, at[4]).spread;
    WaveFunctional<double> f = functional_at(window, at);
    Preconditioner<double> scale(at, n, spread, 1);
    Five<double> direction{};
    int since_restart = 0;
    for (int steps = 0; steps < most_window_steps; ++steps) {
        if (since_restart == 0) {
            scale = Preconditioner<double>(at, n, spread, 1);
            direction = {};
        }
        const Five<double> scaled = scale.apply(f.gradient);
        // g.M^-1.g / n is the mean squared change of the samples by the remaining steps.
        if (dot(f.gradient, scaled) <= tolerance * tolerance * power_of(at) * n) {
            return {at, is_positive(f.hessian)};
        }
        const DescentWay<double> way = next_way(f, scaled, direction);
        direction = way.direction;
        // Point after the exact step, or after the first shorter step that descends. Where F is not
        // convex along the direction, the preconditioned length of the direction is the step.
        const double exact = way.curvature > 0 ? -way.slope / way.curvature : 1;
        constexpr int most_halvings = 30;
        int halving = 0;
        for (double step = exact; halving < most_halvings; ++halving, step /= 2) {
            const Five<double> to = moved(at, direction, step);
            if (!bracket.contains(to[4])) {
                continue;
            }
            const WaveFunctional<double> there = functional_at(window, to);
            if (excess_of(there.value, f.value, step, way.slope) <= 0) {
                at = to;
                f = there;
                break;
            }
        }
        if (halving < most_halvings) {
            since_restart = (since_restart + 1) % descent_restart;
        } else if (since_restart == 0) {
            break;
        } else {
            since_restart = 0;
        }
    }
    return {at, false};
}

VYBEG_DISPATCHED
void in_phase_starts(const ProjectionBatch& __restrict batch, const TaylorFrame& __restrict frame,
                     BatchStart& __restrict start) {
    const InPhaseForm<Vec8> form(products_of(batch), {static_cast<double>(frame.length())});
    const WaveStateOf<Vec8> wave = form.at(jets_at_reference(batch, frame), Vec8{}).wave.wave;
    const Five<Vec8> values = five_of(wave, Vec8{});
    for (std::size_t k = 0; k < values.size(); ++k) {
        store(values[k], start[k]);
    }
}

VYBEG_DISPATCHED
void descend_batch(const ProjectionBatch& __restrict batch, const TaylorFrame& __restrict frame,
                   const BatchStart& __restrict start, SeriesFit<Vec8>& __restrict found) {
    const auto n = static_cast<double>(frame.length());
    const double tolerance = descent_tolerance(frame.w0(), frame.length());
    Five<Vec8> at{load(start[0]), load(start[1]), load(start[2]), load(start[3]), load(start[4])};
    Mask8 good = less(absolute(at[4]), taylor_reach);
    Mask8 on_the_way = good;
    WaveFunctional<Vec8> f = functional_at(batch, frame, at);
    Preconditioner<Vec8> scale(at, n, frame.spread(), 0.5 * n);
    Five<Vec8> direction{};
    for (int steps = 0; steps < most_descent_steps; ++steps) {
        if (steps % descent_restart == 0) {
            scale = Preconditioner<Vec8>(at, n, frame.spread(), 0.5 * n);
            direction = {};
        }
        const Five<Vec8> scaled = scale.apply(f.gradient);
        const Vec8 left = dot(f.gradient, scaled);
        on_the_way = good & !less(left, tolerance * tolerance * n * power_of(at));
        if (!any(on_the_way)) {
            break;
        }
        const DescentWay<Vec8> way = next_way(f, scaled, direction);
        direction = way.direction;
        const Vec8 step = -way.slope / way.curvature;
        // Converged windows keep their parameters.
        at = moved(at, direction, select(on_the_way, step, Vec8{}));
        const Vec8 value = f.value;
        f = functional_at(batch, frame, at);
        const Mask8 taken = good & negative(-way.curvature) & less(absolute(at[4]), taylor_reach) &
                            negative(excess_of(f.value, value, step, way.slope));
        good = good & (taken | !on_the_way);
    }
    const Mask8 arrived = good & !on_the_way & is_positive(f.hessian);
    found.arrived = select(arrived, Vec8{} + 1.0, Vec8{});
    found.residual = load(batch.cc) + load(batch.dd) + f.value;
    const PhasorParts<Vec8> phasors = phasors_of(turned_lanes(at));
    found.motion = motion_power(jets_at(batch, frame, at[4]), spread_by_x(frame));
    found.wave =
        report_batch(batch, frame, at[4], gram_jet(frame, at[4]), phasors, state_of(phasors));
}

}  // namespace vybeg
