#pragma once

#include "core/report/sample_files.h"

namespace vybeg {

// The WAV part of write_stream().
Status write_wav(OutputFile& file, const SampleStream& stream);

}  // namespace vybeg
