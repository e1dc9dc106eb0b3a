#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Name of the supported container whose first bytes (16 or more, if present) a file has: "WAV"
// (RIFF, RIFX), "RF64", "W64", "AIFF" (and AIFF-C), "CAF", "AU" or "FLAC"; empty for other files.
std::string audio_container(std::string_view head);

// Bytes of an ID3v2 tag before FLAC, 0 for every other file.
std::int64_t tag_before_flac(std::string_view head, const FileBytes& file);

// Bytes passed to the decoder instead of those of the file, which it rejects.
struct HeaderPatch {
    std::int64_t at = 0;
    std::string bytes;
};

// Samples of a WAV, RF64 or W64 file that are plain numbers one after the other, where the header
// leaves no doubt of it: fields that repeat each other agree. Integers are fractions of full scale.
struct PlainSamples : NumberArray {
    std::string container;  // "WAV", "WAVEX" (with an extensible header), "RF64" or "W64"
    std::string type_name;  // "Signed 16 bit PCM", "64 bit float", ...
    std::int64_t rate_hz = 0;
};

// Contents of the chunks of an audio file, without decoding.
struct AudioExtent {
    // Number of frames by the header, independent of the real length; empty if the header has none
    // (a streamed file without final length, a packed format, AU, FLAC).
    std::optional<std::int64_t> promised_frames;
    // Position of the first sample in a WAV, RF64 or W64 file, bytes; 0 without one.
    std::int64_t samples_at = 0;
    int bits = 0;       // of integers in a WAV, RF64, W64 or AIFF file
    int packed_as = 0;  // code of a WAV file's packed encoding; 0: its samples are numbers
    // Of an AIFF or CAF file, whose rate may have a fraction, which the decoder drops.
    std::optional<double> rate_hz;
    bool rate_is_zero = false;  // in a WAV, RF64 or W64 file; patched to 1 Hz
    // The sample length of a WAV file is still zero and the samples reach to the end of the file,
    // because the recorder stopped. Patched.
    bool never_closed = false;
    // Also the length of a truncated CAF file, and the names of WAV and RF64 chunks that the
    // decoder does not need, some of which make it loop for ever.
    std::vector<HeaderPatch> patches;
    std::string start;  // date and time, in a WAV or RF64 file; or empty
    std::optional<PlainSamples> plain;
};

// Reads the chunks, in WAV and RF64 files also those after the samples. Contents of chunks cause no
// error; the decoder checks them. Errors: file_read_failed.
Result<AudioExtent> audio_extent(const FileBytes& file);

// An audio file (audio_container()), read on demand: plain samples of WAV, RF64 and W64 in place,
// all others by vybeg-reader, through libsndfile. Integer samples as fractions of full scale (-1 ..
// 1), float samples as they are, NaN and infinite ones as NaN. A file shorter than its header
// states opens with the diagnostic file_ends_early and the frames that can be decoded; a WAV file
// with a sample length of zero, because the recorder stopped, with file_not_closed and the samples
// to its end. Errors: format_damaged, too_few_channels, channel_out_of_range, too_few_frames,
// rate_unknown, interrupted; those of ReaderProcess.
Result<Recording> open_audio(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                             const JobControl& job);

}  // namespace vybeg
