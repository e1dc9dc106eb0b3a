#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace vybeg {

// Functions common to the searches for the carrier.

// Length with zero padding of at least half the length, so that the parabola through the logarithms
// of a peak is accurate: the next power of two, or three times one.
inline std::size_t padded_length(std::size_t length) {
    const std::size_t least = std::max<std::size_t>(length + length / 2, 1024);
    const std::size_t power = std::bit_ceil(least);
    return power / 4 * 3 >= least ? power / 4 * 3 : power;
}

// Position of a peak of the power spectrum between its neighbours, in bins: vertex of the parabola
// through the logarithms.
inline double peak_shift(double left, double here, double right) {
    const double below = std::log(left);
    const double above = std::log(right);
    const double curvature = below - 2 * std::log(here) + above;
    // At the edge of a band the largest bin need not be a peak.
    return curvature < 0 ? std::clamp(0.5 * (below - above) / curvature, -0.5, 0.5) : 0;
}

inline double mean_of_finite(std::span<const double> x) {
    double sum = 0;
    double count = 0;
    for (const double value : x) {
        if (std::isfinite(value)) {
            sum += value;
            count += 1;
        }
    }
    return count > 0 ? sum / count : std::nan("");
}

// Carrier of a long range, coarse to fine, with the accuracy of the spectrum of all samples
// (carrier_search.h) in a fortieth of the time. A short spectrum yields the approximate frequency;
// the samples, filtered and decimated about it in one pass, have a short spectrum of the full
// resolution.
//
// Empty if the result is not certain: power outside the band could make a peak as high; few
// samples; a carrier next to 0 or to half the rate; a cancelled job.
//
// `read` fills both channels from a given sample on. Errors: those of `read`.
using SampleFeed =
    std::function<Status(std::int64_t first, std::span<double> c, std::span<double> d)>;
Result<std::optional<double>> zoom_carrier(const SampleFeed& read, std::size_t count,
                                           double rate_hz, double low_hz, double high_hz,
                                           const JobControl& job);

// The same of samples in memory.
std::optional<double> zoom_carrier(std::span<const double> c, std::span<const double> d,
                                   double rate_hz, double low_hz, double high_hz,
                                   const JobControl& job);

}  // namespace vybeg
