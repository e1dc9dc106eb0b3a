#pragma once

#include "core/resonator/results/resonator_result.h"
#include "core/resonator/runs/wave_motion.h"

#include <array>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// A parameter, with its name in identify JSON.
template <class Owner>
struct ParameterOf {
    const char* name;
    const char* unit;  // "" for a ratio
    Estimate Owner::*member;
    double period = 0;  // of an axis, rad; 0 for values that are no angles
};

// The units at the ends of these names, a longer one before its own ending.
inline constexpr std::array name_units{"_hz_per_s", "_rad_s", "_per_s", "_rad", "_hz", "_s"};

// Of a resonator. Files and comparison iterate over this list.
using ResonatorParameter = ParameterOf<ResonatorEstimate>;

inline constexpr std::array<ResonatorParameter, 12> resonator_parameters{{
    {"f_mean_hz", "Hz", &ResonatorEstimate::f_mean_hz},
    {"split_hz", "Hz", &ResonatorEstimate::split_hz},
    {"theta_w_rad", "rad", &ResonatorEstimate::theta_w_rad, std::numbers::pi / 2},
    {"tau_s", "s", &ResonatorEstimate::tau_s},
    {"q", "", &ResonatorEstimate::q},
    {"damping_anisotropy_per_s", "1/s", &ResonatorEstimate::damping_anisotropy_per_s},
    {"theta_tau_rad", "rad", &ResonatorEstimate::theta_tau_rad, std::numbers::pi / 2},
    {"angle_rate_rad_s", "rad/s", &ResonatorEstimate::angle_rate_rad_s},
    {"kappa", "", &ResonatorEstimate::kappa},
    {"non_orthogonality_rad", "rad", &ResonatorEstimate::non_orthogonality_rad},
    {"delay_s", "s", &ResonatorEstimate::delay_s},
    {"frequency_per_power", "Hz per squared unit", &ResonatorEstimate::frequency_per_power},
}};

// Puts a reason in place of all numbers of an owner, by the table of its parameters.
template <class Table, class Owner>
void refuse(const Table& parameters, const Reason& reason, Owner& owner) {
    for (const auto& parameter : parameters) {
        owner.*parameter.member = Estimate{.reason = reason};
    }
}

// Of each mode.
using ModeParameter = ParameterOf<ModeEstimate>;

inline constexpr std::array<ModeParameter, 3> mode_parameters{{
    {"f_hz", "Hz", &ModeEstimate::f_hz},
    {"tau_s", "s", &ModeEstimate::tau_s},
    {"q", "", &ModeEstimate::q},
}};

// Name of the order of modes, as in the files.
inline const char* mode_order_name(ModeOrder order) {
    return order == ModeOrder::decay ? "decay" : "frequency";
}

// Parameters of each run. Those of the direction refer to the start angle of the wave.
inline constexpr std::array<ParameterOf<RunEstimate>, 9> run_parameters{{
    {"f_offset_hz", "Hz", &RunEstimate::f_offset_hz},
    {"a_A", "", &RunEstimate::a_A},
    {"a_B", "", &RunEstimate::a_B},
    {"two_theta_A_rad", "rad", &RunEstimate::two_theta_A_rad},
    {"split_sin_hz", "Hz", &RunEstimate::split_sin_hz},
    {"direction_f_hz", "Hz", &RunEstimate::direction_f_hz},
    {"direction_tau_s", "s", &RunEstimate::direction_tau_s},
    {"q_envelope", "", &RunEstimate::q_envelope},
    {"drift_hz_per_s", "Hz/s", &RunEstimate::drift_hz_per_s},
}};

// Model-free parameters of the wave of each run.
using WaveParameter = ParameterOf<WaveMotion>;

inline constexpr std::array<WaveParameter, 4> wave_parameters{{
    {"f_hz", "Hz", &WaveMotion::f_hz},
    {"tau_s", "s", &WaveMotion::tau_s},
    {"theta_rate_rad_s", "rad/s", &WaveMotion::theta_rate_rad_s},
    {"quadrature_rate_per_s", "1/s", &WaveMotion::quadrature_rate_per_s},
}};

// Coverage factor of an expanded uncertainty: about 95 % of a normal distribution (GUM 6.2).
inline constexpr double coverage_factor = 2;

// Uncertainty budget of a given parameter (GUM, JCGM 100:2008, 5.1.2): standard uncertainties in
// the parameter's unit.
struct ParameterBudget {
    ResonatorParameter parameter;
    double value = 0;
    double statistical = 0;  // of the noise, type A
    BySource shares{};       // of the tolerances, type B
    double combined = 0;     // u: root of the sum of all squares
    double expanded = 0;     // coverage_factor u
};

// Of the parameters that are given, in the order of resonator_parameters; empty for the free model.
std::vector<ParameterBudget> uncertainty_budget(const ResonatorFit& fit);

// The sources that contribute to any of the parameters.
std::vector<ErrorSource> sources_of(std::span<const ParameterBudget> budget);

// What a resonator's parameter has to keep, in its unit; ends included.
struct ParameterLimit {
    std::string parameter;  // its name there; of no axis, which has no least or greatest value
    std::optional<double> lower;
    std::optional<double> upper;

    friend bool operator==(const ParameterLimit&, const ParameterLimit&) = default;
};

// The greatest size of a difference within its noise, of which its reason speaks; NaN of any other
// estimate.
double greatest_of(const Estimate& size);

// unknown: the parameter has neither value nor bound, or its coverage interval reaches over a
// limit.
enum class Conformity { unknown, within, outside };

// Whether the whole coverage interval lies on one side of the limits: guarded acceptance and
// guarded rejection with guard bands U = 2u, JCGM 106:2012, 8.3.2 and 8.3.3. A difference within
// its noise lies between zero and the greatest value that its reason states. unknown, too, for a
// value without an uncertainty.
Conformity conformity(const Estimate& estimate, const ParameterLimit& limit);

// Whether a resonator keeps all of its limits.
struct LimitVerdict {
    std::optional<Conformity> conformity;  // outside where one parameter is; none: it has no limits
    std::vector<std::string> failed;       // parameters that are not shown to be within
};
LimitVerdict keeps_limits(const ResonatorEstimate& resonator,
                          const std::vector<ParameterLimit>& limits);

// Of this parameter; nullptr: none.
const ParameterLimit* limit_of(const std::vector<ParameterLimit>& limits, const char* parameter);

// The parameters that can have limits.
std::vector<ResonatorParameter> limited_parameters();

}  // namespace vybeg
