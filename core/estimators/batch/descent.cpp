#include "core/estimators/batch/descent.h"

#include "core/estimators/batch/closed_forms.h"

namespace vybeg {
namespace {

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

WaveFunctional<double> evaluate_functional(const WaveParameters& parameters,
                                           const WindowMoments& moments,
                                           const WindowKernel& kernel) {
    return wave_functional(turned(parameters.state), jets_of(moments, kernel),
                           kernel.gram_cos + kernel.gram_sin);
}

VYBEG_DISPATCHED
void in_phase_starts(const ProjectionBatch& __restrict batch, const TaylorFrame& __restrict frame,
                     BatchStart& __restrict start) {
    const InPhaseForm<Vec8> form(products_of(batch), {static_cast<double>(frame.length())});
    const WaveStateOf<Vec8> wave = form.at(jets_at_reference(batch, frame), Vec8{}).wave.wave;
    const Five<Vec8> values{wave.a_A, wave.a_B, wave.two_theta_A, wave.alpha, Vec8{}};
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
