#include "core/resonator/runs/wave_uncertainty.h"

#include "core/resonator/runs/decay_time.h"

#include <array>
#include <cmath>
#include <complex>

namespace vybeg {
namespace {

using Complex = std::complex<double>;

// Members affected by channel errors; tau follows from the decay rate.
constexpr std::array numbers{&WaveMotion::f_hz, &WaveMotion::theta_rate_rad_s,
                             &WaveMotion::quadrature_rate_per_s, &WaveMotion::decay_per_s};

// The run with one more error of its D, by the channels of phasor_model.h.
PhasorRun with_error(const PhasorRun& run, double ChannelTolerance::*error, double size) {
    ChannelTolerance one{.kappa = 0};
    one.*error = size;
    PhasorRun seen = run;
    for (std::size_t k = 0; k < run.d.size(); ++k) {
        const double x = run.time_s[k] / (run.time_s.back() + run.window_s / 2);
        const Complex gain = (1 + one.gain_drift * x) / (1 + one.kappa) *
                             std::polar(1.0, one.phase_rad + one.phase_drift * x);
        Complex c = run.c[k];
        Complex& d = seen.d[k];
        turn_channels(-run.two_theta_zero, c, d);
        d = gain * d + Complex(std::sin(one.skew_rad), one.crosstalk) * c;
        turn_channels(run.two_theta_zero, c, d);
        seen.c[k] = c;
    }
    return seen;
}

}  // namespace

WaveMotion wave_motion(const PhasorRun& run, const ChannelTolerance& tolerance,
                       const JobControl& job) {
    WaveMotion found = wave_motion(run, job);
    std::array<double, numbers.size()> variance{};
    for (const ChannelError& error : channel_errors) {
        const double size = tolerance.*error.tolerance;
        if (size == 0 || job.cancelled()) {
            continue;
        }
        const WaveMotion moved = wave_values(with_error(run, error.tolerance, size), job);
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            const double change = (moved.*numbers[k]).value - (found.*numbers[k]).value;
            variance[k] += std::isfinite(change) ? change * change : 0;
        }
    }
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        Estimate& number = found.*numbers[k];
        number.u = std::sqrt(number.sd * number.sd + variance[k]);
    }
    const Estimate& decay = found.decay_per_s;
    if (decay.given()) {
        found.tau_s = decay_time(decay.value, decay.sd, decay.u);
    }
    return found;
}

}  // namespace vybeg
