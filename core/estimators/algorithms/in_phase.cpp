#include "core/estimators/algorithms/closed_form.h"

#include <cmath>

namespace vybeg {
namespace {

WaveState in_phase_state(const WindowPowers& powers, const Projections& mean) {
    WaveState state;
    state.a_A = std::sqrt(2 * (powers.cc + powers.dd));
    // (15) with the sign that the root has lost.
    state.two_theta_A =
        std::atan2(std::copysign(std::sqrt(powers.dd), powers.cd), std::sqrt(powers.cc));
    state.alpha = wave_phase(state.two_theta_A, mean);
    return state;
}

// Algorithm 1, (15)-(18) with the corrections of METHOD section 2: both signals in phase, no
// quadrature.
class InPhase final : public ClosedFormEstimator {
public:
    explicit InPhase(const EstimatorOptions& options) : ClosedFormEstimator(options) {}

private:
    ClosedForm closed_form(const WindowPowers& powers, const Projections& mean,
                           double) const override {
        const WaveState state = in_phase_state(powers, mean);
        return {state, to_phasors(state)};
    }

    void closed_series(const SeriesBatch& batch, const SeriesFrame& frame,
                       ClosedSeries& found) const override {
        in_phase_series(batch, frame, found);
    }

    Flags own_flags() const override { return static_cast<Flags>(Flag::no_quadrature); }
    int parameter_count() const override { return 4; }
};

}  // namespace

WaveState in_phase_start(const Window& window, double w) {
    return in_phase_state(window_powers(window), demodulate(window, w));
}

std::unique_ptr<Estimator> make_in_phase(const EstimatorOptions& options) {
    return std::make_unique<InPhase>(options);
}

}  // namespace vybeg
