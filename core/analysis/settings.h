#pragma once

#include "core/base/result.h"
#include "core/estimators/wave/estimator.h"
#include "core/recording/conditioning/calibration.h"

#include <cstdint>
#include <optional>
#include <string>

namespace vybeg {

struct Band {
    double low_hz = 0;
    double high_hz = 0;

    friend bool operator==(const Band&, const Band&) = default;
};

// Everything the engineer chooses about an analysis. The defaults are those of the command line.
struct Settings {
    Algorithm algorithm = Algorithm::maximum_likelihood;
    std::int64_t window = 60;       // samples; ignored where periods is set
    std::optional<double> periods;  // window length in periods of the carrier, may be fractional
    bool snap = false;              // move the window to whole half-periods (METHOD section 3)
    std::int64_t hop = 0;           // samples between window starts; 0: the window's length
    std::optional<double> f0_hz;    // skips the search for the carrier
    std::optional<StartValues> initial;  // conjugate gradient only
    StartRule start = StartRule::first;  // conjugate gradient only
    std::optional<double> from_s;
    std::optional<double> to_s;
    std::optional<Band> band;    // where to look for the carrier
    std::optional<Band> filter;  // zero-phase band-pass before everything
    Calibration calibration;
    bool repair_lost = false;  // make gaps of lost samples, so that time runs on behind them
    int threads = 0;           // 0: as many as the machine has, which is also the most

    friend bool operator==(const Settings&, const Settings&) = default;
};

// Checks what can be checked without a recording, and that no value is so large or small that what
// is computed with it loses its digits: setting_invalid with the setting's command-line name.
Status validate(const Settings& settings);

}  // namespace vybeg
