#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"

#include <span>

namespace vybeg {

// Carrier f0 of a range of a recording, Hz: the largest peak common to both channels (power summed)
// of the Hann-windowed spectrum between low_hz and high_hz, refined below a hundredth of a bin,
// where a bin is rate / length. Missing samples (NaN) count as zero. The offset is subtracted
// first. Errors (without `where`): band_invalid, no_valid_samples, carrier_not_found (no peak
// exceeds the band's median by 16 dB), interrupted.
Result<double> find_carrier(std::span<const double> c, std::span<const double> d, double rate_hz,
                            double low_hz, double high_hz, const JobControl& job = {});

}  // namespace vybeg
