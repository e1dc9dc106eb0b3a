#include "core/resonator/mode_estimates.h"

#include "core/base/number_text.h"
#include "core/resonator/slow_dynamics.h"

#include <cmath>
#include <numbers>

namespace vybeg {

std::vector<ModeEstimate> mode_estimates(const DeltaMethod& delta, const Shared& shared,
                                         double f_hz, const Eigen::VectorXd& f_by) {
    using std::numbers::pi;
    const SlowDynamics motion(rates_of(shared));
    std::complex<double> s = motion.half_difference();
    if (s.imag() < 0) {
        s = -s;
    }
    if (s == std::complex<double>{}) {
        return {};
    }
    // s^2 is the analytic function of the rates: ds = d(s^2)/2s.
    Eigen::VectorXd turn_by = delta.gradient();
    Eigen::VectorXd fall_by = delta.gradient();
    for (int k = 0; k < rate_count; ++k) {
        const std::complex<double> by =
            motion.square_by_rate()[static_cast<std::size_t>(k)] / (2.0 * s);
        turn_by[k] = by.imag();
        fall_by[k] = by.real();
    }
    const double spread = std::hypot(delta.sd(turn_by), delta.sd(fall_by));
    if (!(std::abs(s) >= 5 * spread)) {
        return {};
    }
    std::vector<ModeEstimate> modes;
    for (const double sign : {1.0, -1.0}) {
        ModeEstimate mode;
        Eigen::VectorXd by = f_by + sign / (2 * pi) * turn_by;
        mode.f_hz = delta.estimate(f_hz + sign * s.imag() / (2 * pi), by);
        const double decay = shared[rate_count - 1] - sign * s.real();
        Eigen::VectorXd decay_by = -sign * fall_by;
        decay_by[rate_count - 1] = 1;
        const double sd = delta.sd(decay_by);
        if (decay < 3 * sd) {
            mode.tau_s.reason = {ReasonCode::no_decay, {short_text(decay, 3), short_text(sd, 3)}};
            mode.q.reason = mode.tau_s.reason;
        } else {
            mode.tau_s = {1 / decay, sd / (decay * decay), {}};
            mode.q =
                delta.estimate(pi * mode.f_hz.value / decay,
                               pi / decay * by - pi * mode.f_hz.value / (decay * decay) * decay_by);
        }
        modes.push_back(mode);
    }
    return modes;
}

}  // namespace vybeg
