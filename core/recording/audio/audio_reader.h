#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <memory>

namespace vybeg {

// A file that is_audio(), read on demand, through libsndfile unless it is plain_audio(): integer
// samples as fractions of full scale (-1 .. 1), float samples as they are, NaN and infinite ones as
// NaN. A file that ends before its header says so opens with the diagnostic file_ends_early and the
// frames that can be decoded; a WAV file whose recorder died, so that the length of its samples is
// still zero, with file_not_closed and the samples to its end.
// Errors: format_damaged, too_few_channels, channel_out_of_range, too_few_frames, rate_unknown,
// interrupted.
Result<Recording> open_audio(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                             const JobControl& job);

}  // namespace vybeg
