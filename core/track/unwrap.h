#pragma once

#include "core/track/track.h"

namespace vybeg {

// Makes the angle of a track continuous: 2theta_A, as estimated window by window modulo pi, first
// loses `two_theta_zero` (the first electrode's), then follows its last valid value to the nearest
// branch, and alpha is carried along, so that each row stays the same motion. The first valid
// 2theta_A lies in
// (-pi/2, pi/2], alpha in (-pi, pi].
void unwrap_angle(Track& track, double two_theta_zero);

}  // namespace vybeg
