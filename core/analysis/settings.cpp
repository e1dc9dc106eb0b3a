#include "core/analysis/settings.h"

#include "core/base/number_text.h"

#include <cmath>

namespace vybeg {
namespace {

Error invalid(const char* option, double value, const char* allowed) {
    return {ErrorCode::setting_invalid, "", {option, short_text(value, 12), allowed}};
}

bool is_band(const Band& band) {
    return band.low_hz >= 0 && band.high_hz > band.low_hz && std::isfinite(band.high_hz);
}

}  // namespace

Status validate(const Settings& settings) {
    constexpr const char* positive = "it must be above zero";
    constexpr const char* a_number = "it must be a number";
    if (settings.periods && !(*settings.periods > 0 && std::isfinite(*settings.periods))) {
        return invalid("--periods", *settings.periods, positive);
    }
    if (!settings.periods && settings.window < 5) {
        return invalid("--window", static_cast<double>(settings.window),
                       "five parameters need at least 5 samples");
    }
    if (settings.hop < 0) {
        return invalid("--hop", static_cast<double>(settings.hop), positive);
    }
    if (settings.f0_hz && !(*settings.f0_hz > 0 && std::isfinite(*settings.f0_hz))) {
        return invalid("--f0", *settings.f0_hz, positive);
    }
    if (settings.initial) {
        const WaveState& state = settings.initial->state;
        for (const double value :
             {state.a_A, state.a_B, state.two_theta_A, state.alpha, settings.initial->f_hz}) {
            if (!std::isfinite(value)) {
                return invalid("--initial", value, a_number);
            }
        }
        if (!(state.a_A > 0)) {
            return invalid("--initial", state.a_A, "the amplitude a_A must be above zero");
        }
        if (!(settings.initial->f_hz > 0)) {
            return invalid("--initial", settings.initial->f_hz, "the frequency must be above zero");
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
    const Calibration& calibration = settings.calibration;
    if (!(calibration.kappa > 0 && std::isfinite(calibration.kappa))) {
        return invalid("--kappa", calibration.kappa, positive);
    }
    for (const auto& [option, value] :
         {std::pair{"--offset", calibration.offset_c}, std::pair{"--offset", calibration.offset_d},
          std::pair{"--delay", calibration.delay_d_s},
          std::pair{"--angle-zero", calibration.angle_zero_deg}}) {
        if (!std::isfinite(value)) {
            return invalid(option, value, a_number);
        }
    }
    if (settings.threads < 0) {
        return invalid("--threads", settings.threads, positive);
    }
    return {};
}

}  // namespace vybeg
