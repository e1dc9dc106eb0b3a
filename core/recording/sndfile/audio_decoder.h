#pragma once

#include "core/base/result.h"
#include "core/recording/audio/audio_extent.h"
#include "core/recording/bytes/file_bytes.h"

#include <sndfile.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// One libsndfile handle on a file's bytes. Not for several threads at once.
class AudioDecoder {
public:
    // `begin`: bytes before what the library sees. Errors: format_damaged.
    static Result<std::unique_ptr<AudioDecoder>> open(std::shared_ptr<const FileBytes> file,
                                                      const std::vector<HeaderPatch>& patches,
                                                      std::int64_t begin);

    AudioDecoder(const AudioDecoder&) = delete;
    AudioDecoder& operator=(const AudioDecoder&) = delete;
    ~AudioDecoder();

    const SF_INFO& info() const { return info_; }
    std::string container() const;    // e.g. "WAV"
    std::string sample_type() const;  // e.g. "64 bit float"
    std::string start() const;        // date and time from the file, or empty

    // Decodes the frames from `first` on into `out`, interleaved. Errors: format_damaged, if one of
    // them cannot be decoded; the decoder is unusable afterwards.
    Status read(std::int64_t first, std::span<double> out);

private:
    struct Bytes;  // input of libsndfile

    AudioDecoder();
    Error damaged(MessageArg reason) const;

    std::unique_ptr<Bytes> bytes_;
    SNDFILE* handle_ = nullptr;
    SF_INFO info_{};
    std::int64_t position_ = 0;
};

}  // namespace vybeg
