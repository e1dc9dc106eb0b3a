#include "core/track/slow_variables.h"

#include "core/base/message_arg.h"

namespace vybeg {

const SlowVariableInfo& info(SlowVariable variable) {
    static constexpr std::array<SlowVariableInfo, slow_variable_count> table{{
        {"a_A", "a_A", "", VYBEG_MESSAGE("SlowVariable", "amplitude of the working wave"),
         Quantity::amplitude, true},
        {"a_B", "a_B", "", VYBEG_MESSAGE("SlowVariable", "amplitude of the quadrature wave"),
         Quantity::amplitude, true},
        {"two_theta_A_rad", "2θ_A", "rad",
         VYBEG_MESSAGE("SlowVariable", "angle of the standing wave"), Quantity::angle, true},
        {"f_Hz", "ω_cp", "Hz", VYBEG_MESSAGE("SlowVariable", "mean frequency"), Quantity::frequency,
         true},
        {"delta_phi_CD_rad", "Δφ_CD", "rad",
         VYBEG_MESSAGE("SlowVariable", "phase difference of the pick-off signals"), Quantity::angle,
         true},
        {"alpha_rad", "α", "rad", VYBEG_MESSAGE("SlowVariable", "phase of the standing waves"),
         Quantity::angle, true},
        {"noise", "σ", "",
         VYBEG_MESSAGE("SlowVariable", "noise per sample and channel, of the residual"),
         Quantity::amplitude, false},
        {"rms", "rms", "", VYBEG_MESSAGE("SlowVariable", "root of the error functional F"),
         Quantity::amplitude, false},
        {"orthogonality", "⟨S_A S_B⟩", "",
         VYBEG_MESSAGE("SlowVariable", "orthogonality of the standing waves, relative"),
         Quantity::ratio, false},
    }};
    return table[static_cast<std::size_t>(variable)];
}

}  // namespace vybeg
