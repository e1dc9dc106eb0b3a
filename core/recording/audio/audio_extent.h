#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// True where the first bytes of a file (16 or more, where it has them) are those of a container
// that the audio reader knows: WAV (RIFF, RIFX), RF64, W64, AIFF, AIFF-C, CAF, AU or FLAC.
bool is_audio(std::string_view head);

// Bytes that the decoder is to see instead of the file's, because it refuses those.
struct HeaderPatch {
    std::int64_t at = 0;
    std::string bytes;
};

// What the chunks of an audio file say before anybody decodes it.
struct AudioExtent {
    // Frames that the header promises, whatever the file really holds; nothing where it does not
    // tell (a streamed file whose length was never filled in, a packed format, AU, FLAC).
    std::optional<std::int64_t> promised_frames;
    // Of the first sample in a WAV, RF64 or W64 file, in bytes; 0 where there is none.
    std::int64_t samples_at = 0;
    bool rate_is_zero = false;  // in a WAV, RF64 or W64 file; patched to 1 Hz
    // The length of the samples of a WAV file is still zero, and they reach to the file's end: its
    // recorder died. Patched.
    bool never_closed = false;
    // Also a CAF file's length, where the file ends before; and the names of WAV and RF64 chunks
    // that the decoder need not see, some of which make it go round for ever.
    std::vector<HeaderPatch> patches;
};

// Walks the chunks, in WAV and RF64 files also those behind the samples. Never fails on what the
// chunks say: that is the decoder's task. Errors: file_read_failed.
Result<AudioExtent> audio_extent(const FileBytes& file);

}  // namespace vybeg
