#pragma once

#include "core/analysis/settings.h"
#include "core/analysis/tolerance.h"
#include "core/resonator/results/resonator_fit.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// The windows in which phasors are demodulated; without window and periods:
// default_phasor_window().
struct PhasorWindowSettings {
    std::optional<std::int64_t> window = {};  // samples; ignored where periods is set
    std::optional<double> periods = {};       // of the carrier
    bool snap = false;                        // move the window to whole half-periods

    friend bool operator==(const PhasorWindowSettings&, const PhasorWindowSettings&) = default;
};

// Logs in place of recordings: what their columns are (column_wishes() of log_columns.h); empty:
// the set has recordings.
struct LogChoice {
    std::string names;
    double rad_per_angle_unit = 0;  // 0: by the file

    friend bool operator==(const LogChoice&, const LogChoice&) = default;
};

// Everything the engineer chooses about an identification.
struct IdentifySettings {
    SignalSettings signal;
    PhasorWindowSettings windows;
    FitOptions::Model model = FitOptions::Model::automatic;
    Tolerance tolerance;
    int threads = 0;  // 0: as many as the machine has
    // Signal settings of each recording, with the gain ratio of `signal`; empty: those of `signal`
    // hold for all.
    std::vector<SignalSettings> of_recordings = {};
    LogChoice logs = {};

    const SignalSettings& signal_of(std::size_t recording) const {
        return of_recordings.empty() ? signal : of_recordings[recording];
    }

    friend bool operator==(const IdentifySettings&, const IdentifySettings&) = default;
};

}  // namespace vybeg
