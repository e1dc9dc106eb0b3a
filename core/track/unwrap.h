#pragma once

#include "core/track/track.h"

namespace vybeg {

// Makes the angle of a track continuous: 2theta_A, as estimated window by window modulo pi, first
// loses `two_theta_zero` (the first electrode's), then follows its last valid value to the nearest
// branch, and alpha is carried along, so that each row stays the same motion. The first valid
// 2theta_A lies in (-pi/2, pi/2], alpha in (-pi, pi].
//
// Takes the track in pieces, one after the other.
class AngleUnwrapper {
public:
    explicit AngleUnwrapper(double two_theta_zero) : two_theta_zero_(two_theta_zero) {}

    void unwrap(Track& next_rows);

private:
    double two_theta_zero_;
    double last_ = 0;  // the last valid 2theta_A
    bool any_ = false;
};

// A whole track at once.
void unwrap_angle(Track& track, double two_theta_zero);

}  // namespace vybeg
