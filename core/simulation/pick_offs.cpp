#include "core/simulation/pick_offs.h"

#include "core/simulation/turns.h"

#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

double bent(double signal, double cubic) {
    return signal + cubic * signal * signal * signal;
}

}  // namespace

PickOffs::PickOffs(const FreeDecay& decay)
    : decay_(decay),
      from_c_(std::sin(decay.skew_deg * pi / 180), decay.crosstalk),
      drifts_(decay.phase_drift_rad != 0 || decay.gain_drift != 0) {}

std::pair<double, double> PickOffs::signals(const Eigen::Vector2cd& z, std::int64_t frame) const {
    const auto at = static_cast<double>(frame);
    Complex of_d = z(1) + decay_.same_projection * (z(0) - z(1));
    if (drifts_) {
        const double share = at / (decay_.rate_hz * decay_.seconds);
        of_d *= (1 + decay_.gain_drift * share) * std::polar(1.0, decay_.phase_drift_rad * share);
    }
    if (from_c_ != Complex{}) {
        of_d += from_c_ * z(0);
    }
    double c = z(0).real();
    double d = of_d.real() / decay_.kappa;
    for (const ModeBeside& mode : decay_.modes_beside) {
        const double left = std::exp(-at / (decay_.rate_hz * mode.tau_s));
        const double phase = 2 * pi * turns_at(at, mode.f_hz, decay_.rate_hz);
        c += mode.a_C * left * std::cos(phase - mode.phase_C);
        d += mode.a_D * left * std::cos(phase - mode.phase_D);
    }
    if (decay_.pick_off_cubic != 0) {
        c = bent(c, decay_.pick_off_cubic);
        d = bent(d, decay_.pick_off_cubic);
    }
    c += decay_.offset_c;
    d += decay_.offset_d;
    if (decay_.hum != 0) {
        const double phase = 2 * pi * turns_at(at, decay_.hum_hz, decay_.rate_hz);
        const double hum = decay_.hum * std::cos(phase - decay_.hum_phase);
        c += hum;
        d += hum;
    }
    return {c, d};
}

}  // namespace vybeg
