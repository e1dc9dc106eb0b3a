#pragma once

#include <array>

namespace vybeg {

// The slow variables of a track; plots, tables and files iterate over this list.
enum class SlowVariable {
    a_A,
    a_B,
    two_theta_A,
    f,
    delta_phi_CD,
    alpha,
    noise,
    rms,
    orthogonality
};

inline constexpr int slow_variable_count = 9;

inline constexpr std::array<SlowVariable, slow_variable_count> all_slow_variables{
    SlowVariable::a_A,   SlowVariable::a_B,          SlowVariable::two_theta_A,
    SlowVariable::f,     SlowVariable::delta_phi_CD, SlowVariable::alpha,
    SlowVariable::noise, SlowVariable::rms,          SlowVariable::orthogonality};

// Variables of plots and tables. rms is in files only, replaced by noise: rms falls in short
// windows, because five parameters absorb more of their noise.
inline constexpr std::array<SlowVariable, slow_variable_count - 1> shown_slow_variables{
    SlowVariable::a_A,   SlowVariable::a_B,          SlowVariable::two_theta_A,
    SlowVariable::f,     SlowVariable::delta_phi_CD, SlowVariable::alpha,
    SlowVariable::noise, SlowVariable::orthogonality};

// The five that are always plotted, from top to bottom.
inline constexpr std::array<SlowVariable, 5> main_slow_variables{
    SlowVariable::a_A, SlowVariable::a_B, SlowVariable::two_theta_A, SlowVariable::f,
    SlowVariable::delta_phi_CD};

enum class Quantity { amplitude, angle, frequency, ratio };

struct SlowVariableInfo {
    const char* column;   // name in the track CSV, e.g. "two_theta_A_rad"
    const char* symbol;   // for people, e.g. "2θ_A"; the underscore introduces an index
    const char* unit;     // unit of the stored values: "" (recording units), "rad", "Hz"
    const char* meaning;  // English, translatable in context "SlowVariable"
    Quantity quantity;
    bool has_sd;  // with a standard deviation
};

const SlowVariableInfo& info(SlowVariable variable);

}  // namespace vybeg
