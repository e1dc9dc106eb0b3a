#include "core/estimators/batch/series_estimates.h"

#include "core/estimators/batch/series_waves.h"
#include "core/estimators/wave/window_estimate.h"

#include <cmath>
#include <numbers>

// As in lanes.h.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace vybeg {

VYBEG_DISPATCHED
void series_estimates(const SeriesBatch& __restrict batch, const SeriesMaximum& __restrict maximum,
                      const SeriesFrame& __restrict frame, SeriesEstimates& __restrict estimates) {
    const Eight x = load(maximum.x);
    const Bent g_cos = gram_at(frame, x);
    const Eight by_cos = 1 / g_cos.value;
    const Eight by_sin = 1 / (static_cast<double>(frame.length()) - g_cos.value);
    const PhasorLanes phasors{
        projection_at(batch.c_cos, x) * by_cos, -projection_at(batch.c_sin, x) * by_sin,
        projection_at(batch.d_cos, x) * by_cos, -projection_at(batch.d_sin, x) * by_sin};
    complete_lanes(batch, frame, x, g_cos, phasors, state_of(phasors), estimates);
}

WaveEstimate estimate_of_lane(const SeriesEstimates& waves, std::size_t lane, const Window& window,
                              const LaneResidual& residual, const EstimatorOptions& options) {
    const double sum =
        residual_of(residual.difference, residual.power, window,
                    {{waves.c_re[lane], waves.c_im[lane]}, {waves.d_re[lane], waves.d_im[lane]}},
                    waves.w[lane]);
    const auto n = static_cast<double>(window.length());
    const double hertz = options.rate_hz / (2 * std::numbers::pi);
    WaveEstimate estimate;
    estimate.noise = std::sqrt(sum / (2 * n - residual.parameters));
    const EquivalentNoise noises = noise_of(estimate.noise, options);
    const double noise = noises.phasors;
    estimate.state = {waves.a_A[lane], waves.a_B[lane], waves.two_theta_A[lane], waves.alpha[lane]};
    estimate.f_hz = waves.w[lane] * hertz;
    estimate.delta_phi_CD = waves.delta_phi_CD[lane];
    estimate.rms = std::sqrt(sum / n);
    estimate.orthogonality = waves.orthogonality[lane];
    estimate.sd = {noise * waves.sd_a_A[lane], noise * waves.sd_a_B[lane],
                   noise * waves.sd_two_theta_A[lane], noise * waves.sd_alpha[lane]};
    estimate.sd_f_hz = noises.frequency * waves.sd_w[lane] * hertz;
    estimate.sd_delta_phi_CD = noise * waves.sd_delta_phi_CD[lane];
    estimate.flags = residual.flags;
    if (residual.best) {
        add_leakage(estimate, *residual.best);
    }
    drop_what_is_not(estimate, noise, window.length());
    return estimate;
}

}  // namespace vybeg
