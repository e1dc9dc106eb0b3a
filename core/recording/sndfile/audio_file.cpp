#include "core/recording/sndfile/audio_file.h"

#include "core/recording/audio/audio_extent.h"

#include <sndfile.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

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

struct AudioDecoder::Bytes {
    std::shared_ptr<const FileBytes> file;
    std::vector<HeaderPatch> patches;
    std::int64_t begin = 0;  // of what the library sees
    sf_count_t position = 0;

    sf_count_t size() const { return file->size() - begin; }

    sf_count_t seek(sf_count_t offset, int whence) {
        const sf_count_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? position : size();
        position = std::max<sf_count_t>(base + offset, 0);
        return position;
    }

    sf_count_t read(char* out, sf_count_t count) {
        const std::span<char> bytes(out, static_cast<std::size_t>(std::max<sf_count_t>(count, 0)));
        const auto got = file->read(begin + position, bytes);
        if (!got) {
            return 0;
        }
        for (const HeaderPatch& patch : patches) {
            for (std::size_t i = 0; i < patch.bytes.size(); ++i) {
                const std::int64_t at = patch.at + static_cast<std::int64_t>(i) - position;
                if (at >= 0 && at < *got) {
                    out[at] = patch.bytes[i];
                }
            }
        }
        position += *got;
        return *got;
    }
};

std::string without_padding(std::string_view field) {
    const auto end = field.find('\0');
    return std::string(field.substr(0, end));
}

AudioDecoder::AudioDecoder() : bytes_(std::make_unique<Bytes>()) {}

AudioDecoder::~AudioDecoder() {
    if (handle_) {
        sf_close(handle_);
    }
}

Result<std::unique_ptr<AudioDecoder>> AudioDecoder::open(std::shared_ptr<const FileBytes> file,
                                                         const std::vector<HeaderPatch>& patches,
                                                         std::int64_t begin) {
    static SF_VIRTUAL_IO calls = {
        [](void* data) -> sf_count_t { return static_cast<Bytes*>(data)->size(); },
        [](sf_count_t offset, int whence, void* data) {
            return static_cast<Bytes*>(data)->seek(offset, whence);
        },
        [](void* out, sf_count_t count, void* data) {
            return static_cast<Bytes*>(data)->read(static_cast<char*>(out), count);
        },
        [](const void*, sf_count_t, void*) -> sf_count_t { return 0; },
        [](void* data) { return static_cast<Bytes*>(data)->position; }};

    std::unique_ptr<AudioDecoder> decoder(new AudioDecoder);
    decoder->bytes_->file = std::move(file);
    decoder->bytes_->patches = patches;
    decoder->bytes_->begin = begin;
    decoder->handle_ = sf_open_virtual(&calls, SFM_READ, &decoder->info_, decoder->bytes_.get());
    if (!decoder->handle_) {
        return decoder->damaged(words(VYBEG_MESSAGE("Words", "its header cannot be understood")));
    }
    return decoder;
}

Error AudioDecoder::damaged(MessageArg reason) const {
    const std::string name = container();
    return bytes_->file->error(
        ErrorCode::format_damaged,
        {name.empty() ? MessageArg(words(VYBEG_MESSAGE("Words", "audio"))) : name,
         std::move(reason)});
}

std::string AudioDecoder::container() const {
    SF_FORMAT_INFO format{};
    format.format = info_.format & SF_FORMAT_TYPEMASK;
    if (sf_command(handle_, SFC_GET_FORMAT_INFO, &format, sizeof format) != 0 || !format.name) {
        return "";
    }
    const std::string name = format.name;  // "WAV (Microsoft)"
    return name.substr(0, name.find(" ("));
}

std::string AudioDecoder::sample_type() const {
    SF_FORMAT_INFO format{};
    format.format = info_.format & SF_FORMAT_SUBMASK;
    if (sf_command(handle_, SFC_GET_FORMAT_INFO, &format, sizeof format) != 0 || !format.name) {
        return "";
    }
    return format.name;
}

std::string AudioDecoder::start() const {
    SF_BROADCAST_INFO broadcast{};
    if (sf_command(handle_, SFC_GET_BROADCAST_INFO, &broadcast, sizeof broadcast) == SF_TRUE) {
        const std::string date =
            without_padding({broadcast.origination_date, sizeof broadcast.origination_date});
        const std::string time =
            without_padding({broadcast.origination_time, sizeof broadcast.origination_time});
        if (!date.empty()) {
            return time.empty() ? date : date + " " + time;
        }
    }
    const char* date = sf_get_string(handle_, SF_STR_DATE);
    return date ? date : "";
}

Status AudioDecoder::read(std::int64_t first, std::span<double> out) {
    if (position_ != first && sf_seek(handle_, first, SEEK_SET) != first) {
        return damaged(words(VYBEG_MESSAGE("Words", "no sample can be reached at frame %1"),
                             {count_arg(first)}));
    }
    const auto frames = static_cast<std::int64_t>(out.size()) / info_.channels;
    const std::int64_t got = sf_readf_double(handle_, out.data(), frames);
    // libFLAC 1.4 stops before a block with a wrong checksum; earlier versions fill it with zeros,
    // which only sf_error reveals.
    if (sf_error(handle_) != SF_ERR_NO_ERROR) {
        return damaged(words(VYBEG_MESSAGE("Words", "samples from frame %1 on cannot be decoded"),
                             {count_arg(first)}));
    }
    if (got != frames) {
        return damaged(words(VYBEG_MESSAGE("Words", "the samples end at frame %1"),
                             {count_arg(first + std::max<std::int64_t>(got, 0))}));
    }
    position_ = first + frames;
    return {};
}

constexpr std::int64_t block_samples = std::int64_t{1} << 20;  // 8 MB

class AudioFile : public HelperFile {
public:
    explicit AudioFile(std::unique_ptr<AudioDecoder> decoder)
        : decoder_(std::move(decoder)), channels_(decoder_->info().channels) {
        catalogue_.format = decoder_->container();
        catalogue_.start = decoder_->start();
        FileVariable samples;
        samples.frames = decoder_->info().frames;
        samples.channels = channels_;
        samples.type = decoder_->sample_type();
        samples.rate_hz = decoder_->info().samplerate;
        catalogue_.variables.push_back(std::move(samples));
    }

    const Catalogue& catalogue() const override { return catalogue_; }

    Status read(const SampleRequest& request, std::span<double> out) override {
        for (std::int64_t done = 0; done < request.count;) {
            const std::int64_t at = request.first + done;
            if (at < first_ || at >= end()) {
                TRY(decode(at, request.count - done));
            }
            const std::int64_t stop = std::min(request.first + request.count, end());
            for (std::int64_t frame = at; frame < stop; ++frame) {
                const std::int64_t place = (frame - first_) * channels_ + request.channel;
                out[static_cast<std::size_t>(frame - request.first)] =
                    block_[static_cast<std::size_t>(place)];
            }
            done = stop - request.first;
        }
        return {};
    }

private:
    std::int64_t end() const {
        return first_ + static_cast<std::int64_t>(block_.size()) / channels_;
    }

    // All channels, and keeps them: what is decoded for C serves D.
    Status decode(std::int64_t first, std::int64_t frames) {
        frames = std::min(frames, std::max<std::int64_t>(block_samples / channels_, 1));
        first_ = first;
        block_.resize(static_cast<std::size_t>(frames * channels_));
        const Status status = decoder_->read(first, block_);
        if (!status) {
            block_.clear();
        }
        return status;
    }

    std::unique_ptr<AudioDecoder> decoder_;
    std::int64_t channels_;
    Catalogue catalogue_;
    std::vector<double> block_;  // of the frames from first_ on, interleaved
    std::int64_t first_ = 0;
};

}  // namespace

Result<std::unique_ptr<HelperFile>> open_audio_file(std::shared_ptr<const FileBytes> file) {
    const auto start = TRY(file->text(0, 16));
    // Of a file without signature libsndfile looks for a resource fork beside it, which is another
    // file.
    const std::int64_t tag = tag_before_flac(start, *file);
    if (audio_container(start).empty() && tag == 0) {
        return Error{ErrorCode::format_damaged,
                     "",
                     {words(VYBEG_MESSAGE("Words", "audio")),
                      words(VYBEG_MESSAGE("Words", "its header cannot be understood"))}};
    }
    const auto header = TRY(audio_extent(*file));
    auto decoder = TRY(AudioDecoder::open(std::move(file), header.patches, tag));
    return std::unique_ptr<HelperFile>(std::make_unique<AudioFile>(std::move(decoder)));
}

}  // namespace vybeg
