#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <memory>

namespace vybeg {

// Number type of the samples of a layout.
NumberType number_type(RawType type);

// Headerless interleaved samples by options.raw, read on demand; one count is `scale` recording
// units. Bytes after the last whole frame are ignored. Precondition: options.raw is set. Errors:
// setting_invalid, too_few_channels, channel_out_of_range, too_few_frames, rate_unknown.
Result<Recording> open_raw(std::shared_ptr<const FileBytes> file, const OpenOptions& options);

}  // namespace vybeg
