#pragma once

#include "core/track/track.h"

namespace vybeg {

// Makes the angle of a track continuous. From 2theta_A, estimated modulo pi, it subtracts
// `two_theta_zero` (angle of the first electrode, doubled), then selects the branch nearest to the
// last valid value; alpha follows, so that each row remains the same motion. The first valid
// 2theta_A lies in (-pi/2, pi/2], alpha in (-pi, pi].
//
// The track arrives in consecutive pieces.
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
