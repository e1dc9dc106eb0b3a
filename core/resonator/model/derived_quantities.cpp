#include "core/resonator/model/derived_quantities.h"

#include "core/estimators/wave/wave_state.h"
#include "core/resonator/model/phasor_model.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

using std::numbers::pi;

void add_modes(const Eigen::VectorXd& p, ModeOrder order, Eigen::VectorXd& q) {
    std::complex<double> s = std::sqrt(square_half_difference(p));
    if ((order == ModeOrder::frequency ? s.imag() : -s.real()) < 0) {
        s = -s;
    }
    for (const int mode : {0, 1}) {
        const double sign = mode == 0 ? 1 : -1;
        q[mode_f_of + mode] = q[f_mean_of] + sign * s.imag() / (2 * pi);
        q[mode_decay_of + mode] = p[decay_at] - sign * s.real();
    }
}

// Frequency of a run at the power of the wave. The fit has it at that of the recorded channels
// (phasor_model.h), which depends on the gain ratio.
double frequency_of(const Eigen::VectorXd& p, std::size_t run, const QuantityContext& context) {
    const ScaledRun& of = context.runs[run];
    const double more = of.power_sums.at(p[kappa_at]) - of.power_sums.at(1);
    return p[context.layout->at(run, frequency_at)] + p[cubic_at] * more / of.power_kept;
}

void add_run(const Eigen::VectorXd& p, std::size_t run, const QuantityContext& context,
             double f_ref_hz, Eigen::VectorXd& q) {
    const Eigen::VectorXd own = p.segment(context.layout->at(run, 0), own_count);
    const double f = frequency_of(p, run, context);
    const SlowDynamics dynamics(p);
    const Eigen::Vector2cd start =
        dynamics.window_mean(context.runs[run].window_s, own[frequency_at]).inverse() *
        of_real_parts(own.head<4>());
    const WaveState wave = to_wave_state({start[0], start[1]});
    const auto at = [&](RunQuantity quantity) -> double& {
        return q[quantity_of_run(run, quantity)];
    };
    at(a_A_of) = wave.a_A;
    at(a_B_of) = wave.a_B;
    at(two_theta_of) = wave.two_theta_A;
    at(f_of) = f;
    at(f_offset_of) = (context.f_ref_hz[run] - f_ref_hz) + (f - q[f_mean_of]);
    at(run_drift_of) = own[drift_at];
    const double c4 = std::cos(2 * wave.two_theta_A);
    const double s4 = std::sin(2 * wave.two_theta_A);
    at(split_sin_of) = p[split_cos_at] * s4 - p[split_sin_at] * c4;
    const double working = wave.a_A * wave.a_A;
    const double quadrature = wave.a_B * wave.a_B;
    const double share = (working - quadrature) / (working + quadrature) / 2;
    at(direction_f_of) = f + share * (p[split_cos_at] * c4 + p[split_sin_at] * s4);
    at(direction_decay_of) =
        p[decay_at] + share * (p[damping_cos_at] * c4 + p[damping_sin_at] * s4);
}

}  // namespace

double QuantityContext::mean_f_ref_hz() const {
    const double share = 1 / static_cast<double>(f_ref_hz.size());
    double mean = 0;
    for (const double each : f_ref_hz) {
        mean += share * each;
    }
    return mean;
}

std::complex<double> square_half_difference(const Eigen::VectorXd& p) {
    const std::complex<double> s = SlowDynamics(p).half_difference();
    return s * s;
}

Eigen::VectorXd quantities(const Eigen::VectorXd& p, const QuantityContext& context) {
    const std::size_t runs = context.layout->runs();
    Eigen::VectorXd q(quantity_of_run(runs, 0));
    const auto share = 1 / static_cast<double>(runs);
    // References are kept separate, so that differences of frequencies keep their digits.
    double f_mean = 0;
    for (std::size_t run = 0; run < runs; ++run) {
        f_mean += share * frequency_of(p, run, context);
    }
    q[f_mean_of] = f_mean;
    q[decay_of] = p[decay_at];
    q[split_of] = std::hypot(p[split_cos_at], p[split_sin_at]);
    q[theta_w_of] = std::atan2(p[split_sin_at], p[split_cos_at]) / 4;
    q[damping_of] = std::hypot(p[damping_cos_at], p[damping_sin_at]);
    q[theta_tau_of] = std::atan2(p[damping_sin_at], p[damping_cos_at]) / 4;
    q[angle_rate_of] = -p[rotation_at] / 2;
    q[kappa_of] = p[kappa_at];
    q[skew_of] = p[skew_at];
    q[phase_of] = p[phase_at];
    q[cubic_of] = p[cubic_at];
    add_modes(p, context.order, q);
    const double f_ref = context.mean_f_ref_hz();
    for (std::size_t run = 0; run < runs; ++run) {
        add_run(p, run, context, f_ref, q);
    }
    return q;
}

Eigen::VectorXd quantity_periods(std::size_t runs) {
    Eigen::VectorXd period = Eigen::VectorXd::Zero(quantity_of_run(runs, 0));
    period[theta_w_of] = period[theta_tau_of] = pi / 2;
    for (std::size_t run = 0; run < runs; ++run) {
        period[quantity_of_run(run, two_theta_of)] = pi;
    }
    return period;
}

}  // namespace vybeg
