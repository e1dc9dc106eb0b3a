#pragma once

#include "core/estimators/wave/estimator.h"
#include "core/recording/conditioning/conditioned_source.h"

#include <cstdint>
#include <limits>
#include <optional>

namespace vybeg {

// Seconds from the start of the recording; all of it, where nothing is said.
struct TimeRange {
    double from_s = -std::numeric_limits<double>::infinity();
    double to_s = std::numeric_limits<double>::infinity();

    friend bool operator==(const TimeRange&, const TimeRange&) = default;
};

struct Band {
    double low_hz = 0;
    double high_hz = 0;

    friend bool operator==(const Band&, const Band&) = default;
};

// Everything the engineer chooses about an analysis. The defaults are those of the
// command line; setting_table.h holds a row for each field.

// The samples that are analysed, and their conditioning before the windows.
struct SignalSettings {
    std::optional<double> f0_hz;  // skips the search for the carrier
    std::optional<double> from_s;
    std::optional<double> to_s;
    std::optional<Band> band;    // where to look for the carrier
    std::optional<Band> filter;  // zero-phase band-pass before everything
    Calibration calibration;
    bool repair_lost = false;  // make gaps of lost samples, so that time runs on after them

    friend bool operator==(const SignalSettings&, const SignalSettings&) = default;
};

// Whether a search for the carrier and the offsets gives the same with both: all but f0 counts.
bool same_carrier_search(const SignalSettings& a, SignalSettings b);

struct WindowSettings {
    std::int64_t window = 60;       // samples; ignored where periods is set
    std::optional<double> periods;  // window length in periods of the carrier, may be fractional
    bool snap = false;              // move the window to whole half-periods (METHOD section 3)
    std::int64_t hop = 0;           // samples between window starts; 0: the window's length

    friend bool operator==(const WindowSettings&, const WindowSettings&) = default;
};

struct Settings : SignalSettings, WindowSettings {
    Algorithm algorithm = Algorithm::maximum_likelihood;
    std::optional<StartValues> initial;  // conjugate gradient only
    StartRule start = StartRule::first;  // conjugate gradient only
    int threads = 0;                     // 0: as many as the machine has, which is also the most

    friend bool operator==(const Settings&, const Settings&) = default;
};

// The threads that these settings take on this machine.
int threads_of(int asked);

}  // namespace vybeg
