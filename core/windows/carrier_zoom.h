#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace vybeg {

// The carrier of a long stretch coarse to fine, as accurate as by the spectrum of all its samples
// (carrier.h) in a fortieth of the time: a short spectrum says roughly where it is, and the samples
// around that, filtered and thinned out in one pass, have a short spectrum of the full resolution.
//
// Nothing where that cannot be the answer for certain: the largest peak of the whole spectrum might
// lie elsewhere, as the power outside the band that was looked at could make one as high; few
// samples; a carrier next to 0 or to half the rate; or a job that is cancelled.
//
// `read` fills both channels from a sample on. Errors: those of `read`.
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
