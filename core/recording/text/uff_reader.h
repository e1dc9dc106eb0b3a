#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <memory>
#include <string_view>

namespace vybeg {

// True where the first lines of a file are those of a Universal File (UFF): "-1" and the number of
// a dataset.
bool is_uff(std::string_view head);

// The time responses of a Universal File (dataset 58, as text or, 58b, as binary numbers): those
// with as many values, as far apart, as the first one are the channels. Other datasets are passed
// over. Text is read whole, binary numbers on demand; the rate from the values' spacing. A file
// that ends within a dataset opens with the diagnostic file_ends_early. Errors: format_damaged;
// format_unsupported for other binary numbers than those of IEEE 754, complex and unevenly spaced
// values, and where there is no time response; too_few_channels, channel_out_of_range,
// too_few_frames, rate_unknown, interrupted.
Result<Recording> open_uff(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job);

}  // namespace vybeg
