#include "core/recording/sndfile/audio_file.h"

#include "core/recording/audio/audio_extent.h"
#include "core/recording/sndfile/audio_decoder.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

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
    std::array<char, 16> head{};
    TRY(file->read(0, head));
    // Of a file without signature libsndfile looks for a resource fork beside it, which is another
    // file.
    const std::string_view start(head.data(), head.size());
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
