#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/envelope/envelope.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <functional>
#include <memory>
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

// Receives snapshots of a growing envelope.
using EnvelopeSink = std::function<void(std::shared_ptr<const Envelope>)>;

// The envelope of a recording. A long source that seeks is first sampled at up to 2048 places over
// its length, for at most 0.3 s of the job's clock; then every source is read once, front to back.
// `sink` receives a snapshot after the sampling and others at most every 0.1 s of that clock, but
// not the last one, which is the result. Errors: those of the source, interrupted.
Result<std::shared_ptr<const Envelope>> build_envelope(const SampleSource& source,
                                                       const JobControl& job,
                                                       const EnvelopeSink& sink = {});

// Envelope of samples only: buckets of equal parts of the recording. Precondition: frames >= 1.
std::shared_ptr<const Envelope> sampled_envelope(std::int64_t frames,
                                                 std::vector<EnvelopeBucket> samples);

}  // namespace vybeg
