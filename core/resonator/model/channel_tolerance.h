#pragma once

namespace vybeg {

// Tolerances of the channels: standard deviations about the ideal pair, of drifts over a whole run.
// Zero: known exactly.
struct ChannelTolerance {
    double kappa = 0.01;     // relative
    double skew_rad = 0;     // non-orthogonality of the pick-offs
    double phase_rad = 0;    // of D against C: 2 pi f times the delay
    double crosstalk = 0;    // of C into D in quadrature, relative
    double phase_drift = 0;  // rad over a run
    double gain_drift = 0;   // relative, over a run

    friend bool operator==(const ChannelTolerance&, const ChannelTolerance&) = default;
};

}  // namespace vybeg
