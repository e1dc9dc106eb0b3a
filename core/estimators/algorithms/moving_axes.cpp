#include "core/estimators/algorithms/closed_form.h"

#include <algorithm>
#include <cmath>

namespace vybeg {
namespace {

// Algorithm 3, (26)-(30): the signals along and across the wave, then amplitude and phase of each,
// one common frequency from (29).
class MovingAxes final : public ClosedFormEstimator {
public:
    explicit MovingAxes(const EstimatorOptions& options) : ClosedFormEstimator(options) {}

private:
    ClosedForm closed_form(const WindowPowers& powers, const Projections& mean,
                           double) const override {
        const double angle = wave_angle(powers);
        const double cosine = std::cos(angle);
        const double sine = std::sin(angle);
        // (26) in the averages: <S_A^2>, <S_B^2>, and the phases of S_A and S_B, (28).
        const double twist = 2 * powers.cd * sine * cosine;
        const double aa = powers.cc * cosine * cosine + powers.dd * sine * sine + twist;
        const double bb = powers.cc * sine * sine + powers.dd * cosine * cosine - twist;
        const std::complex<double> a = mean.c * cosine + mean.d * sine;
        const std::complex<double> b = mean.d * cosine - mean.c * sine;

        WaveState state;
        state.two_theta_A = angle;
        state.a_A = std::sqrt(2 * aa);
        state.alpha = -std::arg(a);
        // B = a_B sin tau lags behind A by a quarter period where a_B > 0.
        const double lead = std::imag(a * std::conj(b));
        state.a_B = std::copysign(std::sqrt(2 * std::max(bb, 0.0)), lead);
        const std::complex<double> wave_a = std::polar(state.a_A, std::arg(a));
        const std::complex<double> wave_b = std::polar(std::abs(state.a_B), std::arg(b));
        return {state, {wave_a * cosine - wave_b * sine, wave_a * sine + wave_b * cosine}};
    }

    void closed_series(const SeriesBatch& batch, const SeriesFrame& frame,
                       ClosedSeries& found) const override {
        moving_axes_series(batch, frame, found);
    }
};

}  // namespace

std::unique_ptr<Estimator> make_moving_axes(const EstimatorOptions& options) {
    return std::make_unique<MovingAxes>(options);
}

}  // namespace vybeg
