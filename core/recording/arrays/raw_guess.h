#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"

#include <optional>

namespace vybeg {

// Layout of two interleaved channels under which the file looks most like a decay: the one with the
// best prediction x[n] = a x[n-1] - x[n-2], which holds for any narrow band. Skips a header of up
// to 8 KiB with a visible end. Reads at most 80 KiB. The result is only a start value for the user;
// empty if every layout looks like noise. Errors: file_read_failed.
Result<std::optional<RawLayout>> guess_raw_layout(const FileBytes& file);

}  // namespace vybeg
