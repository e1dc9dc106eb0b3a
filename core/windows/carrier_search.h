#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/sample_source.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace vybeg {

// Position of a peak of the power spectrum between its neighbours, in bins: vertex of the parabola
// through the logarithms.
inline double peak_shift(double left, double here, double right) {
    const double below = std::log(left);
    const double above = std::log(right);
    const double curvature = below - 2 * std::log(here) + above;
    // At the edge of a band the largest bin need not be a peak.
    return curvature < 0 ? std::clamp(0.5 * (below - above) / curvature, -0.5, 0.5) : 0;
}

// Carrier of a long range, coarse to fine, with the accuracy of the spectrum of all samples
// (find_carrier()) in a fortieth of the time. A short spectrum yields the approximate frequency;
// the samples, filtered and decimated about it in one pass, have a short spectrum of the full
// resolution.
//
// Empty if the result is not certain: power outside the band could make a peak as high; few
// samples; a carrier next to 0 or to half the rate; a cancelled job.
//
// Errors: those of `read`.
Result<std::optional<double>> zoom_carrier(const ReadFrames& read, std::size_t count,
                                           double rate_hz, double low_hz, double high_hz,
                                           const JobControl& job);

// The same of samples in memory.
std::optional<double> zoom_carrier(std::span<const double> c, std::span<const double> d,
                                   double rate_hz, double low_hz, double high_hz,
                                   const JobControl& job);

// Carrier f0 of a range of a recording, Hz: the largest peak common to both channels (power summed)
// of the Hann-windowed spectrum between low_hz and high_hz, refined below a hundredth of a bin,
// where a bin is rate / length. Missing samples (NaN) count as zero. The offset is subtracted
// first. Errors (without `where`): band_invalid, no_valid_samples, channels_constant,
// carrier_not_found (no peak exceeds the band's median by 16 dB), interrupted.
Result<double> find_carrier(std::span<const double> c, std::span<const double> d, double rate_hz,
                            double low_hz, double high_hz, const JobControl& job = {});

}  // namespace vybeg
