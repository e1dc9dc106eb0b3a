#include "core/estimators/wave/precision_bound.h"

#include <numbers>

namespace vybeg {

Precision precision_bound(const Phasors& phasors, double f_hz, double rate_hz, std::int64_t n,
                          double noise_sd) {
    const double hertz = rate_hz / (2 * std::numbers::pi);
    const PrecisionOf<double> unit =
        unit_precision(parts_of(phasors), window_kernel(n, f_hz / hertz));
    return {{noise_sd * unit.sd.a_A, noise_sd * unit.sd.a_B, noise_sd * unit.sd.two_theta_A,
             noise_sd * unit.sd.alpha},
            noise_sd * unit.w * hertz,
            noise_sd * unit.delta_phi_CD};
}

}  // namespace vybeg
