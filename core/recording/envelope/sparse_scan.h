#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/envelope/envelope_block.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace vybeg {

// Samples at one place of a recording; the place runs from 0 to 1 over its length.
struct ScannedPlace {
    double place = 0;
    EnvelopeBucket seen;
};

// Samples places spread over a whole recording: each of 64 equal parts, then of 128, and so on,
// each part once, up to `most` parts or 0.3 s of the job's clock. Arguments of `look`: number of
// the part, number of parts. The result has one bucket per part, for the largest number of parts
// completed in time; empty if fewer than 64. Errors: those of `look`, interrupted.
Result<std::vector<EnvelopeBucket>> sparse_scan(
    std::int64_t most, const JobControl& job,
    const std::function<Result<ScannedPlace>(std::int64_t part, std::int64_t parts)>& look);

}  // namespace vybeg
