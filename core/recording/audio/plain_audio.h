#pragma once

#include "core/recording/audio/audio_decoder.h"
#include "core/recording/audio/audio_extent.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/sample_source.h"

#include <memory>

namespace vybeg {

// The first `frames` frames of a WAV, RF64 or W64 file whose samples are plain numbers, read
// without the decoder, at the speed of memory and by several threads at once. Null for other files,
// and if the first or the last frame differs from that of the decoder.
std::shared_ptr<const SampleSource> plain_audio(std::shared_ptr<const FileBytes> file,
                                                const AudioExtent& extent, AudioDecoder& decoder,
                                                std::int64_t frames, const OpenOptions& options);

}  // namespace vybeg
