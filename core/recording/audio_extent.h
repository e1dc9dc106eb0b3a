#pragma once

#include "core/base/result.h"
#include "core/recording/file_bytes.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace vybeg {

// True where the first bytes of a file (16 or more, where it has them) are those of a container
// that the audio reader knows: WAV (RIFF, RIFX), RF64, W64, AIFF, AIFF-C, CAF, AU or FLAC.
bool is_audio(std::string_view head);

// What the chunks of an audio file say before anybody decodes it.
struct AudioExtent {
    // Frames that the header promises, whatever the file really holds; nothing where it does not
    // tell (a streamed file whose length was never filled in, a packed format, AU, FLAC).
    std::optional<std::int64_t> promised_frames;
    // Where a WAV or W64 file's sample rate stands (4 bytes), if it is 0.
    std::optional<std::int64_t> zero_rate_at;
};

// Walks the chunks up to the samples. Never fails on what the chunks say: that is the decoder's
// task. Errors: file_read_failed.
Result<AudioExtent> audio_extent(const FileBytes& file);

}  // namespace vybeg
