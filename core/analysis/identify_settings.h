#pragma once

#include "core/analysis/settings.h"
#include "core/base/result.h"
#include "core/base/setting_rows.h"
#include "core/numerics/lock_in.h"
#include "core/resonator/model/channel_tolerance.h"
#include "core/resonator/results/resonator_fit.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

// Units of the angles of a log, rad, as lists of choices have them: by the file, degrees, radians,
// whole turns.
inline constexpr std::array log_angle_units{0.0, std::numbers::pi / 180, 1.0, 2 * std::numbers::pi};

// What the columns of logs are (column_wishes() of log_columns.h).
struct LogChoice {
    std::string names;
    double rad_per_angle_unit = 0;  // one of log_angle_units
    PhasorChoice phasors;

    // Logs in place of recordings.
    bool given() const { return !names.empty() || phasors.frame != PhasorFrame::none; }
    bool without_phase() const { return given() && phasors.frame == PhasorFrame::none; }

    friend bool operator==(const LogChoice&, const LogChoice&) = default;
};

// Of each number of a tolerance.
inline constexpr Bounds tolerance_bounds{0};

// Tolerance where none is stated: the usual size of the error; kappa 0.01, or zero where the
// calibration gives a ratio other than 1; of the clock zero, as its frequencies are those of the
// recorder; of the spread zero, as the fit assumes it where two or three recordings cannot show it.
double assumed_tolerance(ErrorSource source, double calibrated_kappa);

// The tolerances that an identification takes, those of zero left out.
struct ToleranceInUse {
    ToleratedError error;
    double value = 0;
    bool assumed = false;
};
std::vector<ToleranceInUse> tolerances_in_use(const Tolerance& tolerance, double calibrated_kappa);

// The names and texts X of NAME=X[,NAME=X]; nothing where a part has no "=".
std::optional<std::vector<std::pair<std::string, std::string_view>>> named_texts(
    std::string_view text);

// Reads NAME=X[,NAME=X]: the names above, each at most once. X is a number of zero or more in the
// parameter's unit, or with a unit after it: deg, rad, mrad (skew, phase-drift), s, ms, us, ns, ps
// (delay), %, ppm (ratios), ppm, ppb, % (rate). "none" is the default of all. Error:
// setting_invalid of --tolerance with the reason.
Result<Tolerance> read_tolerance(std::string_view text);

// The same text of a tolerance, in its units; "none" where nothing is set. Numbers round-trip.
std::string tolerance_text(const Tolerance& tolerance);

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
