#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/envelope/envelope_block.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace vybeg {

// What was seen at one place of a recording; the place counts from 0 to 1 over its length.
struct Look {
    double place = 0;
    EnvelopeBucket seen;
};

// Looks at places spread over a whole recording: at each of 64 equal parts, then of 128, and so on,
// each part once, until there are `most` parts or 0.3 s of the job's clock are over. `look` is
// given a part's number and how many there are. The result is one bucket per part, of as many parts
// as have all been looked at in time; empty where these are not 64. Errors: those of `look`,
// interrupted.
Result<std::vector<EnvelopeBucket>> look_around(
    std::int64_t most, const JobControl& job,
    const std::function<Result<Look>(std::int64_t part, std::int64_t parts)>& look);

}  // namespace vybeg
