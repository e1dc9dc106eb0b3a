#pragma once

#include "core/base/result.h"
#include "core/base/setting_rows.h"
#include "core/resonator/model/channel_tolerance.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {

// How well the channels and the clock are known, in the units of the command line: standard
// deviations about the calibrated pair. Zero: known exactly; none: see assumed_tolerance().
struct Tolerance {
    std::optional<double> kappa;  // relative
    std::optional<double> skew_deg;
    std::optional<double> delay_s;
    std::optional<double> crosstalk;
    std::optional<double> phase_drift_rad;  // over a run
    std::optional<double> gain_drift;       // over a run
    std::optional<double> rate_ppm;         // of the recorder's sample rate
    std::optional<double> spread;           // of 1/tau between the recordings of a set, relative

    friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

// Of each number of a tolerance.
inline constexpr Bounds tolerance_bounds{0};

// The tolerances: the single list that the option, the settings, the results and the window go
// through.
struct ToleranceParameter {
    ErrorSource source;
    const char* unit;  // of the member; "" for a ratio
    std::optional<double> Tolerance::*member;

    const char* name() const { return tolerance_names[source]; }
};

inline constexpr std::array<ToleranceParameter, 8> tolerance_parameters{{
    {kappa_error, "", &Tolerance::kappa},
    {skew_error, "deg", &Tolerance::skew_deg},
    {delay_error, "s", &Tolerance::delay_s},
    {crosstalk_error, "", &Tolerance::crosstalk},
    {phase_drift_error, "rad", &Tolerance::phase_drift_rad},
    {gain_drift_error, "", &Tolerance::gain_drift},
    {rate_error, "ppm", &Tolerance::rate_ppm},
    {spread_error, "", &Tolerance::spread},
}};

// Tolerance where none is stated: the usual size of the error; kappa 0.01, or zero where the
// calibration gives a ratio other than 1; of the clock zero, as its frequencies are those of the
// recorder; of the spread zero, as the fit assumes it where two or three recordings cannot show it.
double assumed_tolerance(ErrorSource source, double calibrated_kappa);

// The tolerances that an identification takes, those of zero left out.
struct ToleranceInUse {
    ToleranceParameter parameter;
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
// setting_invalid of
// --tolerance with what is wrong.
Result<Tolerance> read_tolerance(std::string_view text);

// The same text of a tolerance, in the units of its members; "none" where nothing is set. Numbers
// round-trip.
std::string tolerance_text(const Tolerance& tolerance);

}  // namespace vybeg
