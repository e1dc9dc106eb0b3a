#pragma once

#include "core/estimators/batch/taylor_window.h"
#include "core/estimators/wave/estimator.h"
#include "core/estimators/wave/wave_state.h"

#include <cstdint>

namespace vybeg {

// The least-squares fit of a window with the four phasor components eliminated (variable
// projection, METHOD section 5.6): the remainder is one function of the frequency.

// p^2/g of one component, added to the power; by_g = 1/g.
template <class Real>
VYBEG_INLINED inline void add_component(Jet2<Real>& power, const Jet2<Real>& p, const Jet2<Real>& g,
                                        Real by_g) {
    const Real ratio = p.value * by_g;
    const Real left = p.slope - ratio * g.slope;
    power.value += p.value * ratio;
    power.slope += ratio * (p.slope + left);
    power.bend += 2 * (left * left) * by_g + ratio * (2 * p.bend - ratio * g.bend);
}

// Power of the best phasors at a frequency (profile power).
template <class Real>
VYBEG_INLINED inline Jet2<Real> profile_power(const WindowJets<Real>& s) {
    const Real by_g = 1 / s.g.value;
    const Real by_h = 1 / s.h.value;
    Jet2<Real> power{};
    add_component(power, s.pc, s.g, by_g);
    add_component(power, s.qc, s.h, by_h);
    add_component(power, s.pd, s.g, by_g);
    add_component(power, s.qd, s.h, by_h);
    return power;
}

// Search range of a window's frequency, radians per sample: the main lobe about the carrier, |f -
// f0| < rate / n, limited to frequencies at which cos and sin are distinct in the window.
struct FrequencyBracket {
    double low = 0;
    double centre = 0;
    double high = 0;

    bool contains(double w) const { return w > low && w < high; }
};

FrequencyBracket main_lobe(double f0_hz, double rate_hz, std::int64_t n);

struct ProfileMaximum {
    double w = 0;
    Phasors phasors;
    Flags flags = 0;  // not_converged; at_bound: the largest power lies at the edge of the bracket
};

// The frequency of largest power in the bracket, by Newton steps from its centre; a search over the
// bracket precedes them where they leave the bracket or the power is not concave. Error of w: 1e-12
// / n.
ProfileMaximum maximise_profile(const Window& window, const FrequencyBracket& bracket);

// The same of eight windows near the reference frequency, by Newton steps on the series.
struct BatchMaximum {
    Lanes x;      // frequency, as in taylor_window.h
    Lanes power;  // of the best phasors
    // 1; 0 where the steps leave the reach of the series or the power is not concave.
    Lanes arrived;
};
void maximise_batch(const ProjectionBatch& batch, const TaylorFrame& frame, BatchMaximum& maximum);

}  // namespace vybeg
