#pragma once

#include "core/estimators/batch/taylor_window.h"
#include "core/estimators/batch/window_estimate.h"
#include "core/estimators/wave/estimator.h"
#include "core/estimators/wave/wave_formulas.h"

#include <cmath>
#include <numbers>

// Algorithms 1 to 4 in both widths. Each Form computes n J, the functional over the frequency,
// (16), (25), (29), less the power of the samples, and the wave at one frequency.

namespace vybeg {

// Constants of the forms for windows of n samples.
struct FormFrame {
    double n = 0;
    double excess = 0;  // algorithm 2: phase of the delay of S_D over pi/2, at the reference
    double excess_by_x = 0;
};
inline FormFrame form_frame(const TaylorFrame& frame, double quarter_period) {
    const auto n = static_cast<double>(frame.length());
    const double excess = frame.w0() * quarter_period - std::numbers::pi / 2;
    return {n, std::abs(excess) < 1e-15 ? 0 : excess, 2 * quarter_period / n};
}

// The signals along the wave's axes: A = C cos 2theta + D sin 2theta, B = D cos 2theta - C sin
// 2theta.
template <class Real>
struct Axes {
    Real cosine;  // of 2theta_A, in (-pi/2, pi/2]
    Real sine;
    Real double_cosine;
    Real double_sine;
};

template <class Real>
struct AxisJets {
    Jet2<Real> p;
    Jet2<Real> q;
};
template <class Real>
VYBEG_INLINED inline AxisJets<Real> along(const Axes<Real>& axes, const WindowJets<Real>& s) {
    return {axes.cosine * s.pc + axes.sine * s.pd, axes.cosine * s.qc + axes.sine * s.qd};
}
template <class Real>
VYBEG_INLINED inline AxisJets<Real> across(const Axes<Real>& axes, const WindowJets<Real>& s) {
    return {axes.cosine * s.pd - axes.sine * s.pc, axes.cosine * s.qd - axes.sine * s.qc};
}

// (20) with the correct factor: the axes on which <S_A S_B> vanishes, without the angle itself.
template <class Real>
VYBEG_INLINED inline Axes<Real> axes_of_powers(const SampleProductsOf<Real>& sum) {
    constexpr double least = 1e-150;  // a circular wave gets the axes of the pick-offs
    const Real across = 2 * sum.cd;
    const Real along = sum.cc - sum.dd + least;
    const Real by_length = 1 / sqrt_of(across * across + along * along);
    const Real double_cosine = along * by_length;
    const Real double_sine = across * by_length + 0.0;  // no -0
    // Half of the angle from the larger of its cosine and sine.
    const Real large = sqrt_of(0.5 + 0.5 * absolute(double_cosine));
    const Real small = 0.5 * absolute(double_sine) / large;
    const Real cosine = select(negative(double_cosine), small, large);
    const Real sine = select(negative(double_cosine), large, small);
    return {cosine, select(negative(double_sine), -sine, sine), double_cosine, double_sine};
}

// p^2 + q^2, the squared length of a signal along an axis; above zero where there is no signal.
template <class Real>
VYBEG_INLINED inline Jet2<Real> squared_length(const Jet2<Real>& p2, const Jet2<Real>& q2) {
    constexpr double least = 1e-300;
    Jet2<Real> r2 = p2 + q2;
    r2.value += least;
    return r2;
}

// Contribution to n J of a wave with constant amplitude a along one axis and the phase of the
// signal: -2 a r + a^2 (p^2 g + q^2 h)/r^2 with r^2 = p^2 + q^2.
template <class Real>
VYBEG_INLINED inline Jet2<Real> axis_functional(const AxisJets<Real>& s, Real a,
                                                const WindowJets<Real>& window) {
    const Jet2<Real> p2 = square(s.p);
    const Jet2<Real> q2 = square(s.q);
    const Jet2<Real> r2 = squared_length(p2, q2);
    return (a * a) * ((p2 * window.g + q2 * window.h) * reciprocal(r2)) - (2 * a) * square_root(r2);
}

// e^{-i arg} of a signal along an axis, e = (p - iq)/r; zero without signal, the case of a wave
// without quadrature across its axis.
template <class Real>
struct Direction {
    Real re;
    Real im;
};
template <class Real>
VYBEG_INLINED inline Direction<Real> direction(const AxisJets<Real>& s) {
    constexpr double least = 1e-300;
    const Real by_r = 1 / (sqrt_of(s.p.value * s.p.value + s.q.value * s.q.value) + least);
    return {s.p.value * by_r, -s.q.value * by_r};
}

// Phasors of waves along and across the axes.
template <class Real>
VYBEG_INLINED inline PhasorParts<Real> turned_back(const Axes<Real>& axes, Direction<Real> a,
                                                   Direction<Real> b) {
    return {a.re * axes.cosine - b.re * axes.sine, a.im * axes.cosine - b.im * axes.sine,
            a.re * axes.sine + b.re * axes.cosine, a.im * axes.sine + b.im * axes.cosine};
}

// alpha by (18) in its correct form: the phase of S_A.
template <class Real>
VYBEG_INLINED inline OrientedWave<Real> wave_on(const Axes<Real>& axes, Real a_A, Real a_B,
                                                const AxisJets<Real>& a) {
    Real angle = 0.5 * atan2_of(axes.double_sine, axes.double_cosine);
    Real alpha = atan2_of(a.q.value, a.p.value);
    make_canonical(angle, alpha);
    return {{a_A, a_B, angle, alpha}, axes.double_cosine, axes.double_sine};
}

template <class Real>
struct ClosedWave {
    PhasorParts<Real> phasors;
    OrientedWave<Real> wave;
};

// What holds of a form that does not say otherwise.
struct AnyForm {
    static constexpr bool has_quadrature = true;
    static constexpr bool delays = false;  // needs S_D delayed by a quarter period
};

// Algorithm 1, (15)-(18) with the corrections of METHOD section 2: both signals in phase, no
// quadrature.
template <class Real>
struct InPhaseForm : AnyForm {
    static constexpr bool has_quadrature = false;

    Axes<Real> axes;
    Real a_A;

    VYBEG_INLINED InPhaseForm(const SampleProductsOf<Real>& sum, const FormFrame& frame) {
        constexpr double least = 1e-300;  // a signal of zero power has no axes
        const Real by_power = 1 / (sum.cc + sum.dd + least);
        axes.cosine = sqrt_of(sum.cc * by_power);
        // (15) with the sign, which the root omits.
        const Real sine = sqrt_of(sum.dd * by_power);
        axes.sine = select(negative(sum.cd), -sine, sine);
        axes.double_cosine = (sum.cc - sum.dd) * by_power;
        axes.double_sine = 2 * axes.cosine * axes.sine;
        a_A = sqrt_of(2 / frame.n * (sum.cc + sum.dd));
    }

    VYBEG_INLINED Jet2<Real> functional(const WindowJets<Real>& s, Real) const {
        return axis_functional(along(axes, s), a_A, s);
    }

    VYBEG_INLINED ClosedWave<Real> at(const WindowJets<Real>& s, Real) const {
        const AxisJets<Real> a = along(axes, s);
        const Direction<Real> e = direction(a);
        return {turned_back(axes, {a_A * e.re, a_A * e.im}, {Real{}, Real{}}),
                wave_on(axes, a_A, Real{}, a)};
    }
};

// Algorithm 2, (19)-(25) with the corrections of METHOD section 2: the quadrature from the
// quarter-period delay of S_D.
template <class Real>
struct PhaseShiftForm : AnyForm {
    static constexpr bool delays = true;

    Axes<Real> axes;
    Real quarter;  // averages
    Real cd;
    Real power;
    FormFrame frame;

    VYBEG_INLINED PhaseShiftForm(const SampleProductsOf<Real>& sum, const FormFrame& of)
        : axes(axes_of_powers(sum)),
          quarter(sum.cq / of.n),
          cd(sum.cd / of.n),
          power((sum.cc + sum.dd) / of.n),
          frame(of) {}

    struct Amplitudes {
        Jet2<Real> a_A;
        Jet2<Real> a_B;
    };
    // (23), (24). The delay is a quarter period of the carrier; at the window's own frequency it is
    // pi/2 + excess, and <S_C S_D(t - t3)> = a_C a_D sin(dphi_CD - excess)/2.
    VYBEG_INLINED Amplitudes amplitudes(Real x) const {
        // cos and sin of the excess by their power series, because |excess| is small and below
        // pi/2, where cos does not vanish.
        const double by_x = frame.excess_by_x;
        const Real all = frame.excess + by_x * x;
        const Real e2 = all * all;
        Real sine = 1 - e2 * (1 / 210.);
        for (const double factor : {1 / 156., 1 / 110., 1 / 72., 1 / 42., 1 / 20., 1 / 6.}) {
            sine = 1 - e2 * factor * sine;
        }
        sine *= all;
        Real cosine = 1 - e2 * (1 / 182.);
        for (const double factor : {1 / 132., 1 / 90., 1 / 56., 1 / 30., 1 / 12., 1 / 2.}) {
            cosine = 1 - e2 * factor * cosine;
        }
        const Real by_cosine = 1 / cosine;
        const Real tangent = sine * by_cosine;
        const Real product = (quarter + cd * sine) * by_cosine;
        const Real slope = cd + product * tangent;
        const Real bend = slope * tangent + product * by_cosine * by_cosine;
        const Jet2<Real> four{4 * product, 4 * by_x * slope, 4 * by_x * by_x * bend};
        const Jet2<Real> total{2 * power, Real{}, Real{}};
        const auto root = [](Jet2<Real> of) VYBEG_INLINED {
            of.value = select(negative(of.value), Real{}, of.value);
            return square_root(of);
        };
        const Jet2<Real> sum = root(total - four);
        const Jet2<Real> difference = root(total + four);
        const Real half = Real{} + 0.5;
        return {half * (sum + difference), half * (sum - difference)};
    }

    VYBEG_INLINED Jet2<Real> functional(const WindowJets<Real>& s, Real x) const {
        const auto [a_A, a_B] = amplitudes(x);
        const AxisJets<Real> a = along(axes, s);
        const AxisJets<Real> b = across(axes, s);
        const Jet2<Real> p2 = square(a.p);
        const Jet2<Real> q2 = square(a.q);
        const Jet2<Real> r2 = squared_length(p2, q2);
        const Jet2<Real> r = square_root(r2);
        const Jet2<Real> taken = a_A * r - a_B * (a.q * b.p - a.p * b.q) * reciprocal(r);
        const Jet2<Real> own =
            square(a_A) * (p2 * s.g + q2 * s.h) + square(a_B) * (q2 * s.g + p2 * s.h);
        return own * reciprocal(r2) - (Real{} + 2.0) * taken;
    }

    VYBEG_INLINED ClosedWave<Real> at(const WindowJets<Real>& s, Real x) const {
        const auto [a_A, a_B] = amplitudes(x);
        const AxisJets<Real> a = along(axes, s);
        const Direction<Real> e = direction(a);
        // B lags behind A by a quarter period: -i a_B e.
        return {turned_back(axes, {a_A.value * e.re, a_A.value * e.im},
                            {a_B.value * e.im, -a_B.value * e.re}),
                wave_on(axes, a_A.value, a_B.value, a)};
    }
};

// Algorithm 3, (26)-(30): the signals along and across the wave, then amplitude and phase of each,
// one common frequency from (29).
template <class Real>
struct MovingAxesForm : AnyForm {
    Axes<Real> axes;
    Real a_A;
    Real a_B;  // its modulus

    VYBEG_INLINED MovingAxesForm(const SampleProductsOf<Real>& sum, const FormFrame& frame)
        : axes(axes_of_powers(sum)) {
        // (26) in the sums.
        const Real twist = 2 * sum.cd * axes.sine * axes.cosine;
        const Real cosine2 = axes.cosine * axes.cosine;
        const Real sine2 = axes.sine * axes.sine;
        const Real aa = sum.cc * cosine2 + sum.dd * sine2 + twist;
        const Real bb = sum.cc * sine2 + sum.dd * cosine2 - twist;
        a_A = sqrt_of(2 / frame.n * aa);
        a_B = sqrt_of(2 / frame.n * select(negative(bb), Real{}, bb));
    }

    VYBEG_INLINED Jet2<Real> functional(const WindowJets<Real>& s, Real) const {
        return axis_functional(along(axes, s), a_A, s) + axis_functional(across(axes, s), a_B, s);
    }

    VYBEG_INLINED ClosedWave<Real> at(const WindowJets<Real>& s, Real) const {
        const AxisJets<Real> a = along(axes, s);
        const Direction<Real> ea = direction(a);
        const Direction<Real> eb = direction(across(axes, s));
        // B = a_B sin tau lags behind A by a quarter period where a_B > 0.
        const Real lead = ea.im * eb.re - ea.re * eb.im;
        return {turned_back(axes, {a_A * ea.re, a_A * ea.im}, {a_B * eb.re, a_B * eb.im}),
                wave_on(axes, a_A, select(negative(lead), -a_B, a_B), a)};
    }
};

// Algorithm 4, (31)-(33) with the correction of METHOD section 2: phasors by synchronous averages.
template <class Real>
struct DemodulationForm : AnyForm {
    double n;

    VYBEG_INLINED DemodulationForm(const SampleProductsOf<Real>&, const FormFrame& frame)
        : n(frame.n) {}

    // With the signals' own averages as phasors, (p^2 g + q^2 h) 4/n^2 - (p^2 + q^2) 4/n.
    VYBEG_INLINED Jet2<Real> functional(const WindowJets<Real>& s, Real) const {
        const Jet2<Real> p2 = square(s.pc) + square(s.pd);
        const Jet2<Real> q2 = square(s.qc) + square(s.qd);
        return (Real{} - 4 / (n * n)) * (p2 * s.h + q2 * s.g);
    }

    VYBEG_INLINED ClosedWave<Real> at(const WindowJets<Real>& s, Real) const {
        const double twice = 2 / n;
        const PhasorParts<Real> phasors{twice * s.pc.value, -twice * s.qc.value, twice * s.pd.value,
                                        -twice * s.qd.value};
        return {phasors, state_of(phasors)};
    }
};

// Minimum of n J over the frequency and the wave at the minimum.
template <class Real>
struct ClosedFit {
    WaveReport<Real> wave;
    BestWaveOf<Real> best;  // of the same samples
    Real residual;          // n J at the minimum
    Real arrived;  // 1; 0 where the steps leave the reach of the series or n J is not convex
};

// Largest |x| at which J is evaluated by its series, with an error of 6e-11.
inline constexpr double closed_form_reach = 0.2;

// The fit of eight windows, by Newton's steps on the projections' series.
using FitBatch = void(const ProjectionBatch& batch, const TaylorFrame& frame, const FormFrame& of,
                      ClosedFit<Vec8>& found);
FitBatch fit_in_phase;
FitBatch fit_phase_shift;
FitBatch fit_moving_axes;
FitBatch fit_demodulation;

}  // namespace vybeg
