#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/variables/reader_protocol.h"

#include <memory>

namespace vybeg {

// An audio file through libsndfile: one variable of all channels. Integer samples are fractions of
// full scale (-1 .. 1), float samples as they are.
Result<std::unique_ptr<HelperFile>> open_audio_file(std::shared_ptr<const FileBytes> file);

}  // namespace vybeg
