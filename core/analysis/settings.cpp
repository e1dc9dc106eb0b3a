#include "core/analysis/settings.h"

#include "core/base/number_text.h"

#include <cmath>

namespace vybeg {
namespace {

Error invalid(const char* option, double value, const char* allowed) {
    return {ErrorCode::setting_invalid, "", {option, short_text(value, 12), allowed}};
}

// The most that samples and offsets may be, so that sums of squares stay finite.
constexpr double most_amplitude = 1e30;
// Angles keep their digits below this, rad.
constexpr double most_angle = 1e6;
constexpr double most_periods = 1e9;
constexpr std::int64_t most_samples = 1'000'000'000'000'000;  // exact as a double
constexpr double least_carrier_hz = 1e-6;

bool within(double value, double most) {
    return std::abs(value) <= most;  // false for NaN
}

bool is_band(const Band& band) {
    return band.low_hz >= 0 && band.high_hz > band.low_hz && std::isfinite(band.high_hz);
}

Status check_initial(const StartValues& initial) {
    const WaveState& state = initial.state;
    if (!(state.a_A > 0)) {
        return invalid("--initial", state.a_A, "the amplitude a_A must be above zero");
    }
    if (!(initial.f_hz > 0 && std::isfinite(initial.f_hz))) {
        return invalid("--initial", initial.f_hz, "the frequency must be above zero");
    }
    for (const double amplitude : {state.a_A, state.a_B}) {
        if (!within(amplitude, most_amplitude)) {
            return invalid("--initial", amplitude, "an amplitude must lie within +-1e30");
        }
    }
    for (const double angle : {state.two_theta_A, state.alpha}) {
        if (!within(angle, most_angle)) {
            return invalid("--initial", angle, "an angle must lie within +-1e6 rad");
        }
    }
    return {};
}

Status check_calibration(const Calibration& calibration) {
    if (!(calibration.kappa >= 1e-6 && calibration.kappa <= 1e6)) {
        return invalid("--kappa", calibration.kappa, "it must lie between 1e-6 and 1e6");
    }
    for (const double offset : {calibration.offset_c, calibration.offset_d}) {
        if (!within(offset, most_amplitude)) {
            return invalid("--offset", offset, "it must lie within +-1e30");
        }
    }
    if (!within(calibration.delay_d_s, 1)) {
        return invalid("--delay", calibration.delay_d_s, "it must lie within +-1 s");
    }
    if (!within(calibration.angle_zero_deg, 360)) {
        return invalid("--angle-zero", calibration.angle_zero_deg,
                       "it must lie within +-360 degrees");
    }
    return {};
}

}  // namespace

Status validate(const Settings& settings) {
    constexpr const char* positive = "it must be above zero";
    constexpr const char* a_number = "it must be a number";
    if (settings.periods && !(*settings.periods > 0 && *settings.periods <= most_periods)) {
        return invalid("--periods", *settings.periods, "it must be above zero and at most 1e9");
    }
    if (!settings.periods && settings.window < 5) {
        return invalid("--window", static_cast<double>(settings.window),
                       "five parameters need at least 5 samples");
    }
    for (const auto& [option, samples] :
         {std::pair{"--window", settings.window}, std::pair{"--hop", settings.hop}}) {
        if (samples > most_samples) {
            return invalid(option, static_cast<double>(samples), "it must be at most 1e15 samples");
        }
    }
    if (settings.hop < 0) {
        return invalid("--hop", static_cast<double>(settings.hop), positive);
    }
    if (settings.f0_hz &&
        !(*settings.f0_hz >= least_carrier_hz && std::isfinite(*settings.f0_hz))) {
        return invalid("--f0", *settings.f0_hz, "it must be at least 1e-6 Hz");
    }
    if (settings.initial) {
        if (const Status valid = check_initial(*settings.initial); !valid) {
            return valid;
        }
    }
    if (settings.from_s && !std::isfinite(*settings.from_s)) {
        return invalid("--from", *settings.from_s, a_number);
    }
    if (settings.to_s && !std::isfinite(*settings.to_s)) {
        return invalid("--to", *settings.to_s, a_number);
    }
    constexpr const char* rising = "a band needs a low edge of at least 0 Hz and a higher edge";
    if (settings.band && !is_band(*settings.band)) {
        return invalid("--band", settings.band->low_hz, rising);
    }
    if (settings.filter && !is_band(*settings.filter)) {
        return invalid("--filter", settings.filter->low_hz, rising);
    }
    if (const Status valid = check_calibration(settings.calibration); !valid) {
        return valid;
    }
    if (settings.threads < 0) {
        return invalid("--threads", settings.threads, positive);
    }
    return {};
}

}  // namespace vybeg
