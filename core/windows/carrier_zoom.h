#pragma once

#include "core/base/job_control.h"

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
std::optional<double> zoom_carrier(std::span<const double> c, std::span<const double> d,
                                   double rate_hz, double low_hz, double high_hz,
                                   const JobControl& job);

}  // namespace vybeg
