#pragma once

#include "core/base/result.h"
#include "core/recording/checks/step_evidence.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// Calibration of the pick-offs. The calibrated signals are
//     C(t) = S_C(t) - offset_c,   D(t) = kappa (S_D(t + delay_d) - offset_d).
// The angle of the first electrode turns tracks and phasors; the samples stay as they are.
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

// The source with a gap of missing samples (NaN) wherever samples were lost, as long as the
// lost samples, so that time runs on after it. Doubled samples stay, and where the phase
// leaves the number of lost samples open it is the one nearest to zero. Steps are in the order of
// their frames. Returns `source` itself where nothing was lost.
std::shared_ptr<const SampleSource> with_gaps(std::shared_ptr<const SampleSource> source,
                                              std::span<const PhaseStep> steps);

// The source after a zero-phase band-pass (METHOD section 3, --filter): a symmetric
// Kaiser-windowed FIR, passband flat within 1e-4 from low_hz to high_hz, 80 dB down beyond a
// transition of half the band's width on either side (less where 0 or half the rate is nearer),
// applied by FFT overlap-save while reading. A channel is NaN where the filter's half-length
// reaches beyond an end or to a missing sample of it. Errors: band_invalid, filter_too_long
// (`where` is left to the caller).
//
// The gain at unit_hz is exactly 1 where that lies in the passband: a carrier keeps its amplitude,
// which windows know better than the passband's ripple. Without it the gain is 1 within the ripple.
Result<std::shared_ptr<const SampleSource>> band_passed(std::shared_ptr<const SampleSource> source,
                                                        double low_hz, double high_hz,
                                                        double rate_hz,
                                                        std::optional<double> unit_hz = {});

// The filter's half-length in samples, which is lost at each end. Precondition: 0 < low_hz <
// high_hz < rate_hz / 2.
std::int64_t band_pass_reach(double low_hz, double high_hz, double rate_hz);

// The half h[0] .. h[M] of its impulse response, M its half-length. Same precondition.
std::vector<double> band_pass_response(double low_hz, double high_hz, double rate_hz);

}  // namespace vybeg
