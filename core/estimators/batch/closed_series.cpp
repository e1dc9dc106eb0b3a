#include "core/estimators/batch/closed_series.h"

#include "core/estimators/batch/lanes.h"
#include "core/estimators/batch/series_waves.h"

#include <cmath>
#include <numbers>

// As in lanes.h.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace vybeg {
namespace {

constexpr int most_steps = 8;
constexpr double pi = std::numbers::pi;

// The projections at one frequency, with their derivatives by x. Of signal S: p = sum S cos wu and
// q = sum S sin wu, hence 2<S e^{-iwu}> = 2/n (p - iq). g = sum cos^2 wu and h = sum sin^2 wu.
struct Spectra {
    Bent pc;
    Bent qc;
    Bent pd;
    Bent qd;
    Bent g;
    Bent h;
};

VYBEG_INLINED inline Spectra spectra(const Bent& pc, const Bent& qc, const Bent& pd, const Bent& qd,
                                     const Bent& g, double n) {
    return {pc, qc, pd, qd, g, {n - g.value, -g.slope, -g.bend}};
}

VYBEG_INLINED inline Spectra spectra_at(const SeriesBatch& batch, const SeriesFrame& frame,
                                        Eight x) {
    const auto at = [x](const std::array<Lanes, series_orders>& sums) VYBEG_INLINED {
        return series_at<series_orders>(x,
                                        [&](std::size_t k) VYBEG_INLINED { return load(sums[k]); });
    };
    return spectra(at(batch.c_cos), at(batch.c_sin), at(batch.d_cos), at(batch.d_sin),
                   gram_at(frame, x), static_cast<double>(frame.length()));
}

// At x = 0 the series are their first coefficients.
VYBEG_INLINED inline Spectra spectra_at_carrier(const SeriesBatch& batch,
                                                const SeriesFrame& frame) {
    const auto at = [](const std::array<Lanes, series_orders>& sums) VYBEG_INLINED {
        return Bent{load(sums[0]), load(sums[1]), 2 * load(sums[2])};
    };
    const auto& gram = frame.gram();
    return spectra(at(batch.c_cos), at(batch.c_sin), at(batch.d_cos), at(batch.d_sin),
                   {Eight{} + gram[0], Eight{} + gram[1], Eight{} + 2 * gram[2]},
                   static_cast<double>(frame.length()));
}

// The signals along the wave's axes: A = C cos 2theta + D sin 2theta, B = D cos 2theta - C sin
// 2theta.
struct Axes {
    Eight cosine;  // of 2theta_A, in (-pi/2, pi/2]
    Eight sine;
    Eight double_cosine;
    Eight double_sine;
};

struct AxisSpectra {
    Bent p;
    Bent q;
};
VYBEG_INLINED inline AxisSpectra along(const Axes& axes, const Spectra& s) {
    return {axes.cosine * s.pc + axes.sine * s.pd, axes.cosine * s.qc + axes.sine * s.qd};
}
VYBEG_INLINED inline AxisSpectra across(const Axes& axes, const Spectra& s) {
    return {axes.cosine * s.pd - axes.sine * s.pc, axes.cosine * s.qd - axes.sine * s.qc};
}

// wave_angle() without the angle: the axes on which <S_A S_B> vanishes.
VYBEG_INLINED inline Axes axes_of_powers(const SeriesBatch& batch) {
    const Eight across = 2 * load(batch.cd);
    const Eight along = load(batch.cc) - load(batch.dd);
    const Eight by_length = 1 / sqrt_of(across * across + along * along);
    const Eight double_cosine = along * by_length;
    const Eight double_sine = across * by_length + 0.0;  // no -0
    // Half of the angle by the larger of its cosine and sine.
    const Eight large = sqrt_of(0.5 + 0.5 * absolute(double_cosine));
    const Eight small = 0.5 * absolute(double_sine) / large;
    const Eight cosine = if_negative(double_cosine, small, large);
    const Eight sine = if_negative(double_cosine, large, small);
    return {cosine, if_negative(double_sine, -sine, sine), double_cosine, double_sine};
}

// What a wave of constant amplitude a along one axis adds to n J, its phase being that of the
// signal: -2 a r + a^2 (p^2 g + q^2 h)/r^2 with r^2 = p^2 + q^2.
VYBEG_INLINED inline Bent axis_functional(const AxisSpectra& s, Eight a, const Bent& g,
                                          const Bent& h) {
    const Bent p2 = square(s.p);
    const Bent q2 = square(s.q);
    const Bent r2 = p2 + q2;
    return (a * a) * ((p2 * g + q2 * h) * reciprocal(r2)) - (2 * a) * square_root(r2);
}

// e^{-i arg} of a signal along an axis, e = (p - iq)/r; nought where there is no signal, which only
// a wave without quadrature has across its axis.
struct Direction {
    Eight re;
    Eight im;
};
VYBEG_INLINED inline Direction direction(const AxisSpectra& s) {
    constexpr double least = 1e-300;
    const Eight by_r = 1 / (sqrt_of(s.p.value * s.p.value + s.q.value * s.q.value) + least);
    return {s.p.value * by_r, -s.q.value * by_r};
}

// Phasors of waves along and across the axes.
VYBEG_INLINED inline PhasorLanes turned_back(const Axes& axes, Direction a, Direction b) {
    return {a.re * axes.cosine - b.re * axes.sine, a.im * axes.cosine - b.im * axes.sine,
            a.re * axes.sine + b.re * axes.cosine, a.im * axes.sine + b.im * axes.cosine};
}

struct Found {
    PhasorLanes phasors;
    StateLanes state;
};

VYBEG_INLINED inline StateLanes state_on(const Axes& axes, Eight a_A, Eight a_B,
                                         const AxisSpectra& a) {
    Eight angle = 0.5 * atan2_of(axes.double_sine, axes.double_cosine);
    Eight alpha = atan2_of(a.q.value, a.p.value);
    make_canonical(angle, alpha);
    return {a_A, a_B, angle, alpha, axes.double_cosine, axes.double_sine};
}

struct InPhaseForm {
    Axes axes;
    Eight a_A;

    VYBEG_INLINED InPhaseForm(const SeriesBatch& batch, double n) {
        const Eight cc = load(batch.cc);
        const Eight dd = load(batch.dd);
        const Eight by_power = 1 / (cc + dd);
        axes.cosine = sqrt_of(cc * by_power);
        const Eight sine = sqrt_of(dd * by_power);
        axes.sine = if_negative(load(batch.cd), -sine, sine);
        axes.double_cosine = (cc - dd) * by_power;
        axes.double_sine = 2 * axes.cosine * axes.sine;
        a_A = sqrt_of(2 / n * (cc + dd));
    }

    VYBEG_INLINED Bent functional(const Spectra& s, Eight) const {
        return axis_functional(along(axes, s), a_A, s.g, s.h);
    }

    VYBEG_INLINED Found at(const Spectra& s, Eight) const {
        const AxisSpectra a = along(axes, s);
        const Direction e = direction(a);
        return {turned_back(axes, {a_A * e.re, a_A * e.im}, {Eight{}, Eight{}}),
                state_on(axes, a_A, Eight{}, a)};
    }
};

struct PhaseShiftForm {
    Axes axes;
    Eight quarter;  // averages
    Eight cd;
    Eight power;
    double excess;  // of the delay over pi/2, at the frame's frequency
    double excess_by_x;

    VYBEG_INLINED PhaseShiftForm(const SeriesBatch& batch, const SeriesFrame& frame, double n,
                                 double quarter_period)
        : axes(axes_of_powers(batch)),
          quarter(load(batch.cq) / n),
          cd(load(batch.cd) / n),
          power((load(batch.cc) + load(batch.dd)) / n),
          excess(std::abs(frame.w0() * quarter_period - pi / 2) < 1e-15
                     ? 0
                     : frame.w0() * quarter_period - pi / 2),
          excess_by_x(2 * quarter_period / n) {}

    struct Amplitudes {
        Bent a_A;
        Bent a_B;
    };
    // (23), (24) with the sine of dphi_CD from (quarter + cd sin excess)/cos excess.
    VYBEG_INLINED Amplitudes amplitudes(Eight x) const {
        // |excess| < 1: by their power series.
        const Eight all = excess + excess_by_x * x;
        const Eight e2 = all * all;
        const Eight sine =
            all * (1 - e2 / 6 * (1 - e2 / 20 * (1 - e2 / 42 * (1 - e2 / 72 * (1 - e2 / 110)))));
        const Eight cosine =
            1 - e2 / 2 * (1 - e2 / 12 * (1 - e2 / 30 * (1 - e2 / 56 * (1 - e2 / 90))));
        const Eight by_cosine = 1 / cosine;
        const Eight tangent = sine * by_cosine;
        const Eight product = (quarter + cd * sine) * by_cosine;
        const Eight slope = cd + product * tangent;
        const Eight bend = slope * tangent + product * by_cosine * by_cosine;
        const Bent four{4 * product, 4 * excess_by_x * slope, 4 * excess_by_x * excess_by_x * bend};
        const Bent total{2 * power, Eight{}, Eight{}};
        const Bent sum = square_root(total - four);
        const Bent difference = square_root(total + four);
        const Eight half = Eight{} + 0.5;
        return {half * (sum + difference), half * (sum - difference)};
    }

    VYBEG_INLINED Bent functional(const Spectra& s, Eight x) const {
        const auto [a_A, a_B] = amplitudes(x);
        const AxisSpectra a = along(axes, s);
        const AxisSpectra b = across(axes, s);
        const Bent p2 = square(a.p);
        const Bent q2 = square(a.q);
        const Bent r2 = p2 + q2;
        const Bent r = square_root(r2);
        const Bent taken = a_A * r - a_B * (a.q * b.p - a.p * b.q) * reciprocal(r);
        const Bent own = square(a_A) * (p2 * s.g + q2 * s.h) + square(a_B) * (q2 * s.g + p2 * s.h);
        return own * reciprocal(r2) - (Eight{} + 2.0) * taken;
    }

    VYBEG_INLINED Found at(const Spectra& s, Eight x) const {
        const auto [a_A, a_B] = amplitudes(x);
        const AxisSpectra a = along(axes, s);
        const Direction e = direction(a);
        // B lags behind A by a quarter period: -i a_B e.
        return {turned_back(axes, {a_A.value * e.re, a_A.value * e.im},
                            {a_B.value * e.im, -a_B.value * e.re}),
                state_on(axes, a_A.value, a_B.value, a)};
    }
};

struct MovingAxesForm {
    Axes axes;
    Eight a_A;
    Eight a_B;  // its modulus

    VYBEG_INLINED MovingAxesForm(const SeriesBatch& batch, double n) : axes(axes_of_powers(batch)) {
        const Eight cc = load(batch.cc);
        const Eight dd = load(batch.dd);
        const Eight twist = 2 * load(batch.cd) * axes.sine * axes.cosine;
        const Eight cosine2 = axes.cosine * axes.cosine;
        const Eight sine2 = axes.sine * axes.sine;
        const Eight aa = cc * cosine2 + dd * sine2 + twist;
        const Eight bb = cc * sine2 + dd * cosine2 - twist;
        a_A = sqrt_of(2 / n * aa);
        a_B = sqrt_of(2 / n * if_negative(bb, Eight{}, bb));
    }

    VYBEG_INLINED Bent functional(const Spectra& s, Eight) const {
        return axis_functional(along(axes, s), a_A, s.g, s.h) +
               axis_functional(across(axes, s), a_B, s.g, s.h);
    }

    VYBEG_INLINED Found at(const Spectra& s, Eight) const {
        const AxisSpectra a = along(axes, s);
        const AxisSpectra b = across(axes, s);
        const Direction ea = direction(a);
        const Direction eb = direction(b);
        // a_B > 0 where B lags behind A.
        const Eight lead = ea.im * eb.re - ea.re * eb.im;
        return {turned_back(axes, {a_A * ea.re, a_A * ea.im}, {a_B * eb.re, a_B * eb.im}),
                state_on(axes, a_A, if_negative(lead, -a_B, a_B), a)};
    }
};

struct DemodulationForm {
    double n;

    VYBEG_INLINED DemodulationForm(const SeriesBatch&, double count) : n(count) {}

    // With the signals' own averages as phasors, (p^2 g + q^2 h) 4/n^2 - (p^2 + q^2) 4/n.
    VYBEG_INLINED Bent functional(const Spectra& s, Eight) const {
        const Bent p2 = square(s.pc) + square(s.pd);
        const Bent q2 = square(s.qc) + square(s.qd);
        return (Eight{} - 4 / (n * n)) * (p2 * s.h + q2 * s.g);
    }

    VYBEG_INLINED Found at(const Spectra& s, Eight) const {
        const double twice = 2 / n;
        const PhasorLanes phasors{twice * s.pc.value, -twice * s.qc.value, twice * s.pd.value,
                                  -twice * s.qd.value};
        return {phasors, state_of(phasors)};
    }
};

// Maximum likelihood from the same sums, by Newton's steps on the profile power from the closed
// form's frequency: against it shows what the closed form leaves out. Lanes at which the power is
// not concave, or that leave the series' reach, have not arrived.
VYBEG_INLINED inline void find_best(const SeriesBatch& batch, const SeriesFrame& frame, Eight x,
                                    Spectra s, ClosedSeries& found) {
    Eight good = load(found.arrived);
    Eight move{};
    for (int step = 0;; ++step) {
        const Bent power = (square(s.pc) + square(s.pd)) * reciprocal(s.g) +
                           (square(s.qc) + square(s.qd)) * reciprocal(s.h);
        move = -power.slope / power.bend;
        good = if_negative(power.bend, good, Eight{});
        good = if_negative(absolute(x + move) - closed_form_reach, good, Eight{});
        move = if_negative(0.5 - good, move, Eight{});
        // Behind a move of 1e-4 the step ends within 1e-12, and so do the projections' parabolas.
        const Eight on_the_way = if_negative(absolute(move) - 1e-4, Eight{}, good);
        if (total(on_the_way) == 0 || step == most_steps) {
            good -= on_the_way;
            break;
        }
        x += move;
        s = spectra_at(batch, frame, x);
    }
    const auto moved = [move](const Bent& a) VYBEG_INLINED {
        return a.value + move * (a.slope + 0.5 * move * a.bend);
    };
    const Eight by_g = 1 / moved(s.g);
    const Eight by_h = 1 / moved(s.h);
    const PhasorLanes z{moved(s.pc) * by_g, -moved(s.qc) * by_h, moved(s.pd) * by_g,
                        -moved(s.qd) * by_h};
    const StateLanes state = state_of(z);
    store(good, found.arrived);
    store(frame.w0() + 2 * (x + move) / static_cast<double>(frame.length()), found.best_w);
    store(state.a_A, found.best_a_A);
    store(state.a_B, found.best_a_B);
    store(state.two_theta_A, found.best_two_theta_A);
    store(state.alpha, found.best_alpha);
    store(atan2_of(z.d_im * z.c_re - z.d_re * z.c_im, z.d_re * z.c_re + z.d_im * z.c_im),
          found.best_delta_phi_CD);
}

// The minimum of n J, less the power that all windows have, and the waves there.
template <class Form>
VYBEG_INLINED inline void minimise_form(const SeriesBatch& batch, const SeriesFrame& frame,
                                        const Form& form, ClosedSeries& found) {
    Eight good = Eight{} + 1.0;  // or 0
    Eight x{};
    Eight residual{};
    Bent f = form.functional(spectra_at_carrier(batch, frame), x);
    for (int step = 0;; ++step) {
        const Eight move = -f.slope / f.bend;
        const Eight next = x + move;
        // As in maximise_series().
        good = if_negative(-f.bend, good, Eight{});
        good = if_negative(absolute(next) - closed_form_reach, good, Eight{});
        x = if_negative(0.5 - good, next, x);
        residual = f.value + 0.5 * f.slope * move;
        // Behind a move of 1e-5 is one of 1e-10 at most.
        const Eight on_the_way = if_negative(absolute(move) - 1e-5, Eight{}, good);
        if (total(on_the_way) == 0 || step == most_steps) {
            store(good - on_the_way, found.arrived);
            break;
        }
        f = form.functional(spectra_at(batch, frame, x), x);
    }
    store(load(batch.cc) + load(batch.dd) + residual, found.residual);
    const Spectra there = spectra_at(batch, frame, x);
    const Found waves = form.at(there, x);
    find_best(batch, frame, x, there, found);
    complete_lanes(batch, frame, x, there.g, waves.phasors, waves.state, found.waves);
}

}  // namespace

VYBEG_DISPATCHED
void in_phase_series(const SeriesBatch& __restrict batch, const SeriesFrame& __restrict frame,
                     ClosedSeries& __restrict found) {
    const InPhaseForm form(batch, static_cast<double>(frame.length()));
    minimise_form(batch, frame, form, found);
}

VYBEG_DISPATCHED
void phase_shift_series(const SeriesBatch& __restrict batch, const SeriesFrame& __restrict frame,
                        double quarter_period, ClosedSeries& __restrict found) {
    const PhaseShiftForm form(batch, frame, static_cast<double>(frame.length()), quarter_period);
    minimise_form(batch, frame, form, found);
}

VYBEG_DISPATCHED
void moving_axes_series(const SeriesBatch& __restrict batch, const SeriesFrame& __restrict frame,
                        ClosedSeries& __restrict found) {
    const MovingAxesForm form(batch, static_cast<double>(frame.length()));
    minimise_form(batch, frame, form, found);
}

VYBEG_DISPATCHED
void demodulation_series(const SeriesBatch& __restrict batch, const SeriesFrame& __restrict frame,
                         ClosedSeries& __restrict found) {
    const DemodulationForm form(batch, static_cast<double>(frame.length()));
    minimise_form(batch, frame, form, found);
}

}  // namespace vybeg
