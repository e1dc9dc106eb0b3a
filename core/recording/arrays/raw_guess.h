#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"

#include <optional>

namespace vybeg {

// The layout of two interleaved channels under which the file looks most like a decay: the one
// whose samples are best told from the two before them, x[n] = a x[n-1] - x[n-2], as those of any
// narrow band are. Skips a header of up to 8 KiB whose end is seen. Reads at most 80 KiB; a start
// value for the engineer, no more. Nothing where it all looks like noise. Errors: file_read_failed.
Result<std::optional<RawLayout>> guess_raw_layout(const FileBytes& file);

}  // namespace vybeg
