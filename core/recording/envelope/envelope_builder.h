#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/envelope/envelope.h"
#include "core/recording/samples/sample_source.h"

#include <functional>
#include <memory>

namespace vybeg {

// Takes pictures of an envelope while it grows.
using EnvelopeSink = std::function<void(std::shared_ptr<const Envelope>)>;

// The envelope of a recording. A long source that seeks is first looked at in up to 2048 places
// spread over all of it, for at most 0.3 s of the job's clock; then every source is read once,
// front to back. `sink` gets a picture behind the first look and another at most every 0.1 s of
// that clock, never the last one, which is the result. Errors: those of the source, interrupted.
Result<std::shared_ptr<const Envelope>> build_envelope(const SampleSource& source,
                                                       const JobControl& job,
                                                       const EnvelopeSink& sink = {});

// An envelope of which nothing but samples is known: buckets of equal parts of the recording.
// Precondition: frames >= 1.
std::shared_ptr<const Envelope> sampled_envelope(std::int64_t frames,
                                                 std::vector<EnvelopeBucket> samples);

}  // namespace vybeg
