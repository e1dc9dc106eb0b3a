#pragma once

#include "core/analysis/settings.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/estimators/wave/estimator.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <vector>

namespace vybeg {

// Behind a band-pass the noise is not white: what is left of it inside a window follows the wave,
// and the residual shows a part only. What a window's estimates are uncertain by is told by the
// noise's density about the carrier, which the filter leaves as it was.

// Noise inside the passband as white noise of the same density, sd per sample and channel,
// recording units: the median of the spectrum from low_hz to high_hz, which the lines of the modes
// do not move, of the longest run without missing samples, up to 2^18 frames, of [first, end) of a
// source behind that band-pass. NaN where that is too short to have a frequency inside the band.
// Errors: those of the source; interrupted.
Result<double> noise_in_band(const SampleSource& source, std::int64_t first, std::int64_t end,
                             const Band& band, double rate_hz, const JobControl& job);

// White noise that would move phasors and frequency of a window of n samples at f0 as much as noise
// of density `noise` inside the band-pass does: the density times the band's share of the power
// spectra of the weights, cos w0 u and u sin w0 u, by which a window takes in noise. Both are
// `noise` for long windows and smaller for windows shorter than the inverse of the bandwidth.
EquivalentNoise equivalent_noise(double noise, const Band& band, double f0_hz, std::int64_t n,
                                 double rate_hz);

// Correlation of the errors of f of two windows of n samples behind the band-pass, by the hops
// between them, from 1 to where it has died away.
std::vector<double> frequency_correlation(const Band& band, double f0_hz, std::int64_t n,
                                          std::int64_t hop, double rate_hz);

}  // namespace vybeg
