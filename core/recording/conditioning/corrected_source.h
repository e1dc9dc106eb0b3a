#pragma once

#include "core/recording/checks/step_evidence.h"
#include "core/recording/samples/sample_source.h"

#include <memory>
#include <numbers>
#include <span>

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

// The source with offsets, gain ratio and delay of D taken out (Calibration), while reading. The
// delay is a band-limited interpolation; the frames at both ends that it cannot reach are NaN in D
// and in C, and D is NaN where it would take in a missing sample. offset_auto must have been
// resolved into offsets before. Returns `source` itself where there is nothing to do.
std::shared_ptr<const SampleSource> calibrated(std::shared_ptr<const SampleSource> source,
                                               const Calibration& calibration, double rate_hz);

// The source with a gap of missing samples (NaN) wherever samples were lost, as long as what was
// lost, so that time runs on behind it. Doubled samples stay, and where the phase
// does not tell how many were lost it is the number nearest to zero. Steps are in the order of
// their frames. Returns `source` itself where nothing was lost.
std::shared_ptr<const SampleSource> with_gaps(std::shared_ptr<const SampleSource> source,
                                              std::span<const PhaseStep> steps);

}  // namespace vybeg
