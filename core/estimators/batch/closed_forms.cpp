#include "core/estimators/batch/closed_forms.h"

#include "core/estimators/batch/profile.h"
#include "core/estimators/wave/jet.h"

namespace vybeg {
namespace {

constexpr int most_steps = 8;

constexpr auto in_reach = [](Vec8 x) VYBEG_INLINED { return less(absolute(x), closed_form_reach); };

// Maximum likelihood from the same sums, by Newton's steps on the profile power from the closed
// form's frequency; the difference is the error of the closed form.
VYBEG_INLINED inline BestWaveOf<Vec8> find_best(const ProjectionBatch& batch,
                                                const TaylorFrame& frame, Vec8 x,
                                                WindowJets<Vec8> s, Mask8& arrived) {
    // After a move of 1e-4 the step ends within 1e-12, and so do the projections' parabolas.
    const NewtonEnd<Vec8> end = newton(
        x, profile_power(s), {true, 1e-4, most_steps},
        [&](Vec8 at) VYBEG_INLINED {
            s = jets_at(batch, frame, at);
            return profile_power(s);
        },
        in_reach);
    arrived = arrived & end.arrived;
    const Vec8 move = end.move;
    const auto moved = [move](const Jet2<Vec8>& a) VYBEG_INLINED {
        return a.value + move * (a.slope + 0.5 * move * a.bend);
    };
    const Vec8 by_g = 1 / moved(s.g);
    const Vec8 by_h = 1 / moved(s.h);
    const PhasorParts<Vec8> z{moved(s.pc) * by_g, -moved(s.qc) * by_h, moved(s.pd) * by_g,
                              -moved(s.qd) * by_h};
    const auto along = [move](const Jet2<Vec8>& a) VYBEG_INLINED {
        return Jet2<Vec8>{a.value + move * (a.slope + 0.5 * move * a.bend), a.slope + move * a.bend,
                          a.bend};
    };
    return {state_of(z).wave, frame.w0() + 2 * (end.x + move) / static_cast<double>(frame.length()),
            phase_difference_of(z), end.value(),
            motion_power(WindowJets<Vec8>{along(s.pc), along(s.qc), along(s.pd), along(s.qd),
                                          along(s.g), along(s.h)},
                         spread_by_x(frame))};
}

template <template <class> class Form>
VYBEG_INLINED inline void fit(const ProjectionBatch& batch, const TaylorFrame& frame,
                              const FormFrame& of, ClosedFit<Vec8>& found) {
    const Form<Vec8> form(products_of(batch), of);
    // After a move of 1e-5 is one of 1e-10 at most.
    const NewtonEnd<Vec8> end = newton(
        Vec8{}, form.functional(jets_at_reference(batch, frame), Vec8{}), {false, 1e-5, most_steps},
        [&](Vec8 x) VYBEG_INLINED { return form.functional(jets_at(batch, frame, x), x); },
        in_reach);
    found.residual = load(batch.cc) + load(batch.dd) + end.value();
    const Vec8 x = end.x + end.move;
    const WindowJets<Vec8> there = jets_at(batch, frame, x);
    const ClosedWave<Vec8> closed = form.at(there, x);
    Mask8 arrived = end.arrived;
    found.best = find_best(batch, frame, x, there, arrived);
    found.arrived = select(arrived, Vec8{} + 1.0, Vec8{});
    found.wave = report_batch(batch, frame, x, there.g, closed.phasors, closed.wave);
}

}  // namespace

VYBEG_DISPATCHED
void fit_in_phase(const ProjectionBatch& __restrict batch, const TaylorFrame& __restrict frame,
                  const FormFrame& __restrict of, ClosedFit<Vec8>& __restrict found) {
    fit<InPhaseForm>(batch, frame, of, found);
}

VYBEG_DISPATCHED
void fit_phase_shift(const ProjectionBatch& __restrict batch, const TaylorFrame& __restrict frame,
                     const FormFrame& __restrict of, ClosedFit<Vec8>& __restrict found) {
    fit<PhaseShiftForm>(batch, frame, of, found);
}

VYBEG_DISPATCHED
void fit_moving_axes(const ProjectionBatch& __restrict batch, const TaylorFrame& __restrict frame,
                     const FormFrame& __restrict of, ClosedFit<Vec8>& __restrict found) {
    fit<MovingAxesForm>(batch, frame, of, found);
}

VYBEG_DISPATCHED
void fit_demodulation(const ProjectionBatch& __restrict batch, const TaylorFrame& __restrict frame,
                      const FormFrame& __restrict of, ClosedFit<Vec8>& __restrict found) {
    fit<DemodulationForm>(batch, frame, of, found);
}

}  // namespace vybeg
