#pragma once

#include "core/report/sample_files.h"

namespace vybeg {

// The WAV part of write_samples().
Status write_wav(OutputFile& file, const Samples& samples, const JobControl& job);

}  // namespace vybeg
