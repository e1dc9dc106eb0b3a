#pragma once

#include "core/base/result.h"
#include "core/base/setting_rows.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace vybeg {

// How well the channels are known, in the units of the command line: standard deviations about the
// calibrated pair. Zero: known exactly.
struct Tolerance {
    std::optional<double> kappa;  // relative; none: default_kappa_tolerance()
    double skew_deg = 0;
    double delay_s = 0;
    double crosstalk = 0;
    double phase_drift_rad = 0;  // over a run
    double gain_drift = 0;       // over a run

    friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

// Tolerance of the gain ratio where none is given: exact where the calibration gives a ratio other
// than 1.
double default_kappa_tolerance(double kappa);

// Of each number of a tolerance.
inline constexpr Bounds tolerance_bounds{0};

// The tolerances besides kappa by their names on the command line: the single list that the
// option, the settings and the window go through.
struct ToleranceParameter {
    const char* name;
    const char* unit;  // of the member; "" for a ratio
    double Tolerance::*member;
};

inline constexpr std::array<ToleranceParameter, 5> tolerance_parameters{{
    {"skew", "deg", &Tolerance::skew_deg},
    {"delay", "s", &Tolerance::delay_s},
    {"crosstalk", "", &Tolerance::crosstalk},
    {"phase-drift", "rad", &Tolerance::phase_drift_rad},
    {"gain-drift", "", &Tolerance::gain_drift},
}};

// Reads NAME=X[,NAME=X]: kappa and the names above, each at most once. X is a number of zero or
// more in the parameter's unit, or with a unit after it: deg, rad, mrad (skew, phase-drift), s, ms,
// us, ns, ps (delay), %, ppm (ratios). "none" is the default of all. Error: setting_invalid of
// --tolerance with what is wrong.
Result<Tolerance> read_tolerance(std::string_view text);

// The same text of a tolerance, in the units of its members; "none" where nothing is set. Numbers
// round-trip.
std::string tolerance_text(const Tolerance& tolerance);

}  // namespace vybeg
