#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <memory>

namespace vybeg {

// An audio file (audio_container()), read on demand: plain samples of WAV, RF64 and W64 in place,
// all others by vybeg-reader, through libsndfile. Integer samples as fractions of full scale (-1 ..
// 1), float samples as they are, NaN and infinite ones as NaN. A file shorter than its header
// states opens with the diagnostic file_ends_early and the frames that can be decoded; a WAV file
// with a sample length of zero, because the recorder stopped, with file_not_closed and the samples
// to its end. Errors: format_damaged, too_few_channels, channel_out_of_range, too_few_frames,
// rate_unknown, interrupted; those of ReaderProcess.
Result<Recording> open_audio(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                             const JobControl& job);

}  // namespace vybeg
