#pragma once

#include "core/recording/samples/sample_source.h"

#include <memory>
#include <numbers>

namespace vybeg {

// What is known of the pick-offs. The calibrated signals are
//     C(t) = S_C(t) - offset_c,   D(t) = kappa (S_D(t + delay_d) - offset_d).
// The angle of the first electrode is no matter of the samples: analyse() subtracts it.
struct Calibration {
    double kappa = 1;     // gain ratio of the channels, METHOD section 1
    double offset_c = 0;  // recording units
    double offset_d = 0;
    bool offset_auto =
        false;             // the offsets are each channel's mean over whole periods of the carrier
    double delay_d_s = 0;  // by how much channel D comes late, seconds
    double angle_zero_deg = 0;  // angle of the first electrode; subtracted from theta_A

    double two_theta_zero() const { return angle_zero_deg * std::numbers::pi / 90; }  // rad

    friend bool operator==(const Calibration&, const Calibration&) = default;
};

}  // namespace vybeg
