#pragma once

#include "core/analysis/settings.h"
#include "core/analysis/tolerance.h"
#include "core/numerics/lock_in.h"
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

// Whose phase the phasors of a log refer to.
enum class PhasorFrame {
    none,    // the files hold samples, or no phase
    fixed,   // one frequency, both channels
    common,  // an oscillator that moves, both channels: a column of its frequency or phase
    pll      // each channel its own phase, a column each
};

// As --phasors names it; "" for none.
const char* frame_name(PhasorFrame frame);

// How a lock-in or a phasemeter has made its phasors. No data show the sign of Y or whether
// amplitudes are peak values: the user says both.
struct PhasorChoice {
    PhasorFrame frame = PhasorFrame::none;
    double f_ref_hz = 0;       // 0: by the file
    int y_sign = 0;            // 1: X + iY turns as the carrier does, -1: against it; 0: not given
    double peak_per_unit = 0;  // 1, or sqrt(2) of rms values; 0: not given
    LockIn filter;             // order 0: not given

    friend bool operator==(const PhasorChoice&, const PhasorChoice&) = default;
};

// Logs in place of recordings: what their columns are (column_wishes() of log_columns.h).
struct LogChoice {
    std::string names;
    double rad_per_angle_unit = 0;  // 0: by the file
    PhasorChoice phasors;

    // Otherwise the set has recordings.
    bool given() const { return !names.empty() || phasors.frame != PhasorFrame::none; }
    bool without_phase() const { return given() && phasors.frame == PhasorFrame::none; }

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
