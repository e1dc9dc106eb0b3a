#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace vybeg {

// Carrier of a long range, coarse to fine, with the accuracy of the spectrum of all samples
// (carrier.h) in a fortieth of the time. A short spectrum yields the approximate frequency; the
// samples, filtered and decimated about it in one pass, have a short spectrum of the full
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
