#pragma once

#include "core/analysis/prepare.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace vybeg {

// What the spectrum shows around the carrier of a recording: the lines of its modes, the density
// of the noise between them, and the lines of the mains.
struct CarrierLines {
    // The modes' lines, Hz. All three are f0 where no line stands out.
    double strongest_hz = 0;
    double lowest_hz = 0;
    double highest_hz = 0;
    bool found = false;
    // Variance per sample and channel of the white noise that has the density found beside the
    // carrier, and its relative standard deviation; the median over segments. NaN where the
    // samples are too few.
    double noise_power = std::numeric_limits<double>::quiet_NaN();
    int segments = 0;  // that it was found in
    double relative_sd = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> mains_hz;
};

// Looks at up to 32 segments of the prepared range, each of 64 windows (`window` samples) where
// the range is long enough, with a Kaiser window whose side lobes of -150 dB keep an offset and
// other modes out of the carrier's surroundings. A line is a peak of the mean spectrum
// that stands above its noise and above 1e-7 of the strongest one. The modes' lines are those
// within 80 Hz (at most an eighth of the carrier, and within the band-pass) of the strongest line
// of the main lobe around f0; where the main lobe has none and the engineer gave f0, of the
// strongest line within 400 Hz (at most a third of f0). Errors: those of the source,
// carrier_not_near where the engineer gave f0 and no line stands there, interrupted.
Result<CarrierLines> carrier_lines(const ConditionedRecording& prepared,
                                   const SignalSettings& settings, std::int64_t window,
                                   double rate_hz, const JobControl& job);

}  // namespace vybeg
