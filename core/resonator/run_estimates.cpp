#include "core/resonator/run_estimates.h"

#include "core/base/number_text.h"
#include "core/estimators/wave_state.h"
#include "core/resonator/envelope_decay.h"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <numbers>

namespace vybeg {

RunEstimate run_estimate(const DeltaMethod& delta, const FitState& state, std::size_t run,
                         double window_s, double scale) {
    using Complex = std::complex<double>;
    constexpr Complex i{0, 1};
    const Own& own = state.runs[run];
    const SlowDynamics motion(rates_of(state.shared));
    const Eigen::Vector2cd z =
        motion.window_mean(window_s, own[frequency_index]).inverse() * start_of(own);
    const WaveState wave = to_wave_state({z[0], z[1]});

    // |u+-| and arg u+- by Re and Im of c and d: d|u| = Re(conj(u) du)/|u|, d arg = Im(..)/|u|^2.
    const Complex u_plus = z[0] + i * z[1];
    const Complex u_minus = z[0] - i * z[1];
    constexpr std::array<Complex, 4> plus_by{1, i, i, -1};
    constexpr std::array<Complex, 4> minus_by{1, i, -i, 1};
    Eigen::VectorXd a_by = delta.gradient();
    Eigen::VectorXd b_by = delta.gradient();
    Eigen::VectorXd angle_by = delta.gradient();
    for (std::size_t k = 0; k < 4; ++k) {
        const Complex plus = std::conj(u_plus) * plus_by[k];
        const Complex minus = std::conj(u_minus) * minus_by[k];
        const double grow_plus = plus.real() / std::abs(u_plus);
        const double grow_minus = minus.real() / std::abs(u_minus);
        const auto place = DeltaMethod::place(run, start_index + static_cast<int>(k));
        a_by[place] = (grow_plus + grow_minus) / 2;
        b_by[place] = (grow_plus - grow_minus) / 2;
        angle_by[place] = (plus.imag() / std::norm(u_plus) - minus.imag() / std::norm(u_minus)) / 2;
    }
    RunEstimate out;
    const double a_sd = delta.sd(a_by);
    out.a_A = {scale * wave.a_A, scale * a_sd, {}};
    out.a_B = {scale * wave.a_B, scale * delta.sd(b_by), {}};
    if (wave.a_A - std::abs(wave.a_B) < 3 * a_sd) {
        out.two_theta_A_rad.reason = {ReasonCode::circular_wave, {}};
        out.split_sin_hz.reason = {ReasonCode::circular_wave, {}};
        return out;
    }
    out.two_theta_A_rad = delta.estimate(wave.two_theta_A, angle_by);
    const double c4 = std::cos(2 * wave.two_theta_A);
    const double s4 = std::sin(2 * wave.two_theta_A);
    Eigen::VectorXd by = 2 * (state.shared[0] * c4 + state.shared[1] * s4) * angle_by;
    by[0] = s4;
    by[1] = -c4;
    out.split_sin_hz = delta.estimate(state.shared[0] * s4 - state.shared[1] * c4, by);
    return out;
}

void envelope_estimate(RunEstimate& estimate, const ScaledRun& scaled, const FitState& state,
                       std::size_t run, double f_hz, double enlargement,
                       std::vector<Diagnostic>& warnings) {
    const EnvelopeDecay envelope = envelope_decay(scaled, state.shared, state.runs[run]);
    const double sd = envelope.sd * std::sqrt(enlargement);
    if (!std::isfinite(sd)) {
        estimate.q_envelope.reason = {ReasonCode::too_few_windows, {}};
        return;
    }
    if (envelope.per_s < 3 * sd) {
        estimate.q_envelope.reason = {ReasonCode::no_decay,
                                      {short_text(envelope.per_s, 3), short_text(sd, 3)}};
    } else {
        const double q = std::numbers::pi * f_hz / envelope.per_s;
        estimate.q_envelope = {q, q * sd / envelope.per_s, {}};
    }
    if (std::abs(envelope.per_s - envelope.model_per_s) > 3 * sd) {
        warnings.push_back({DiagnosticKind::q_disagrees,
                            {integer_text(static_cast<std::int64_t>(run) + 1),
                             short_text(std::numbers::pi * f_hz / envelope.per_s, 4),
                             short_text(std::numbers::pi * f_hz / envelope.model_per_s, 4)}});
    }
}

}  // namespace vybeg
