#include "core/estimators/algorithms/closed_form.h"
#include "core/numerics/fractional_delay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

// Algorithm 2, (19)-(25) with the corrections of METHOD section 2: the quadrature from the
// quarter-period delay of S_D.
class PhaseShift final : public ClosedFormEstimator {
public:
    explicit PhaseShift(const EstimatorOptions& options)
        : ClosedFormEstimator(options),
          quarter_period_(options.rate_hz / (4 * options.f0_hz)),
          delay_(quarter_period_) {}

    std::int64_t context() const override {
        return std::max(delay_.reach_before(), delay_.reach_after());
    }

private:
    std::vector<double> quarter_delayed(const WindowBlock& block) const override {
        // NaN where the delay reaches outside.
        const auto frames = static_cast<std::int64_t>(block.d.size());
        std::vector<double> delayed(block.d.size(), std::numeric_limits<double>::quiet_NaN());
        const std::int64_t from = std::max(block.first, delay_.reach_before());
        const std::int64_t to = frames - delay_.reach_after();
        if (from < to) {
            delay_.apply(block.d, from,
                         std::span(delayed).subspan(static_cast<std::size_t>(from),
                                                    static_cast<std::size_t>(to - from)));
        }
        return delayed;
    }

    ClosedForm closed_form(const WindowPowers& powers, const Projections& mean,
                           double w) const override {
        // The delay is a quarter period of the carrier; at the window's own frequency it is
        // pi/2 + excess, and <S_C S_D(t - t3)> = a_C a_D sin(dphi_CD - excess)/2.
        const double excess = w * quarter_period_ - std::numbers::pi / 2;
        const double sine = (powers.quarter + powers.cd * std::sin(excess)) / std::cos(excess);
        const double total = 2 * (powers.cc + powers.dd);
        const double sum = std::sqrt(std::max(total - 4 * sine, 0.0));
        const double difference = std::sqrt(std::max(total + 4 * sine, 0.0));
        WaveState state;
        state.a_A = (sum + difference) / 2;
        state.a_B = (sum - difference) / 2;
        state.two_theta_A = wave_angle(powers);
        state.alpha = wave_phase(state.two_theta_A, mean);
        return {state, to_phasors(state)};
    }

    void closed_series(const SeriesBatch& batch, const SeriesFrame& frame,
                       ClosedSeries& found) const override {
        phase_shift_series(batch, frame, quarter_period_, found);
    }

    double quarter_period_;  // of the carrier, samples
    FractionalDelay delay_;
};

}  // namespace

std::unique_ptr<Estimator> make_phase_shift(const EstimatorOptions& options) {
    return std::make_unique<PhaseShift>(options);
}

}  // namespace vybeg
