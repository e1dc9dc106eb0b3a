#pragma once

#include "core/output/output_file.h"
#include "core/output/sample_stream.h"

namespace vybeg {

// The WAV part of write_stream().
Status write_wav(OutputFile& file, const SampleStream& stream);

}  // namespace vybeg
