#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/envelope/envelope.h"
#include "core/recording/samples/sample_source.h"

#include <functional>
#include <memory>

namespace vybeg {

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
