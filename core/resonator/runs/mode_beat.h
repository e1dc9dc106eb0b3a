#pragma once

#include "core/resonator/runs/sum_of_modes.h"
#include "core/track/track.h"

#include <cstddef>
#include <optional>

namespace vybeg {

// The beat of a resonator between two times of one track: the two modes of its free decay, whose
// sum the phasors of all windows follow (METHOD section 8). Large swings of a_B and 2theta_A,
// which are no sinusoids, are such sums.
struct ModeBeat {
    ModeSum modes;  // their shapes are those at from_s
    double from_s = 0;
    double centre_s = 0;  // where a drift changes no frequency
    double f_ref_hz = 0;
    double drift_hz_s = 0;
    double two_theta_zero = 0;
    double frequency_hz = 0;  // by which the modes differ
    double sd_frequency_hz = 0;

    // One of main_slow_variables; 2theta_A modulo pi, delta_phi_CD modulo a turn.
    double at(SlowVariable variable, double time_s) const;
};

// By the windows that count for a trend (core/track/trend.h) and have phasors. `two_theta_zero`:
// twice the angle of the first electrode, subtracted from that of the track. Where the windows
// scatter about two modes by more than their noise, both modes get one drift of their frequencies,
// and a white scatter that remains enlarges the deviations. Nothing where the motion is another
// one, where a mode or the difference of both lies within six deviations of zero, or for less than
// one and a quarter periods.
std::optional<ModeBeat> find_mode_beat(const Track& track, double f_ref_hz, double two_theta_zero,
                                       double from_s, double to_s, std::size_t apart);

}  // namespace vybeg
