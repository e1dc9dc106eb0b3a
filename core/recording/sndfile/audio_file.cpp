#include "core/recording/sndfile/audio_file.h"

#include "core/recording/audio/audio_reader.h"

#include <sndfile.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// The bytes that libsndfile gets instead of the file.
struct PatchedBytes {
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

PatchedBytes& patched(void* data) {
    return *static_cast<PatchedBytes*>(data);
}

constexpr std::int64_t block_samples = std::int64_t{1} << 20;  // 8 MB

class AudioFile : public HelperFile {
public:
    explicit AudioFile(PatchedBytes bytes) : bytes_(std::move(bytes)) {}
    ~AudioFile() override {
        if (handle_) {
            sf_close(handle_);
        }
    }

    // `packed_as`: AudioExtent.
    Status open(int packed_as) {
        static SF_VIRTUAL_IO calls = {
            [](void* data) { return patched(data).size(); },
            [](sf_count_t offset, int whence, void* data) {
                return patched(data).seek(offset, whence);
            },
            [](void* out, sf_count_t count, void* data) {
                return patched(data).read(static_cast<char*>(out), count);
            },
            [](const void*, sf_count_t, void*) -> sf_count_t { return 0; },
            [](void* data) { return patched(data).position; }};
        handle_ = sf_open_virtual(&calls, SFM_READ, &info_, &bytes_);
        if (!handle_ && packed_as != 0) {
            return bytes_.file->unsupported("WAV",
                                            VYBEG_MESSAGE("Words", "samples in the encoding %1"),
                                            {count_arg(packed_as)});
        }
        if (!handle_) {
            return damaged(VYBEG_MESSAGE("Words", "its header cannot be understood"));
        }
        catalogue_.format = container();
        // That of WAV files is read by audio_extent().
        const char* const date = sf_get_string(handle_, SF_STR_DATE);
        catalogue_.start = date ? date : "";
        FileVariable samples;
        samples.frames = info_.frames;
        samples.channels = info_.channels;
        samples.type = format_name(SF_FORMAT_SUBMASK);
        samples.rate_hz = info_.samplerate;
        catalogue_.variables.push_back(std::move(samples));
        return {};
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
                const std::int64_t place = (frame - first_) * info_.channels + request.channel;
                out[static_cast<std::size_t>(frame - request.first)] =
                    block_[static_cast<std::size_t>(place)];
            }
            done = stop - request.first;
        }
        return {};
    }

private:
    std::int64_t end() const {
        return first_ + static_cast<std::int64_t>(block_.size()) / info_.channels;
    }

    // All channels, and keeps them: the block decoded for C serves D. Errors: format_damaged, if
    // one of the frames cannot be decoded; libsndfile is of no use afterwards.
    Status decode(std::int64_t first, std::int64_t frames) {
        const std::int64_t channels = info_.channels;
        frames = std::min(frames, std::max<std::int64_t>(block_samples / channels, 1));
        first_ = first;
        block_.resize(static_cast<std::size_t>(frames * channels));
        const auto failed = [this](const char* text, std::int64_t frame) {
            block_.clear();
            return damaged(text, {count_arg(frame)});
        };
        if (position_ != first_ && sf_seek(handle_, first_, SEEK_SET) != first_) {
            return failed(VYBEG_MESSAGE("Words", "no sample can be reached at frame %1"), first_);
        }
        const std::int64_t got = sf_readf_double(handle_, block_.data(), frames);
        // libFLAC 1.4 stops before a block with a wrong checksum; earlier versions fill it with
        // zeros, which only sf_error reveals.
        if (sf_error(handle_) != SF_ERR_NO_ERROR) {
            return failed(VYBEG_MESSAGE("Words", "samples from frame %1 on cannot be decoded"),
                          got < frames ? first_ + std::max<std::int64_t>(got, 0) : first_);
        }
        if (got != frames) {
            return failed(VYBEG_MESSAGE("Words", "the samples end at frame %1"),
                          first_ + std::max<std::int64_t>(got, 0));
        }
        position_ = first_ + frames;
        return {};
    }

    // E.g. "64 bit float" of the samples; empty where the library knows no name.
    std::string format_name(int mask) const {
        SF_FORMAT_INFO format{};
        format.format = info_.format & mask;
        const int failed = sf_command(handle_, SFC_GET_FORMAT_INFO, &format, sizeof format);
        return failed != 0 || !format.name ? "" : format.name;
    }

    std::string container() const {
        const std::string name = format_name(SF_FORMAT_TYPEMASK);  // "WAV (Microsoft)"
        return name.substr(0, name.find(" ("));
    }

    Error damaged(const char* text, std::vector<MessageArg> args = {}) const {
        const std::string name = container();
        return bytes_.file->error(
            ErrorCode::format_damaged,
            {name.empty() ? MessageArg(Phrase::tr("audio")) : name, words(text, std::move(args))});
    }

    PatchedBytes bytes_;
    SNDFILE* handle_ = nullptr;
    SF_INFO info_{};
    std::int64_t position_ = 0;  // of the library, frames
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
                     {Phrase::tr("audio"), Phrase::tr("its header cannot be understood")}};
    }
    const auto header = TRY(audio_extent(*file));
    auto audio = std::make_unique<AudioFile>(PatchedBytes{std::move(file), header.patches, tag});
    TRY(audio->open(header.packed_as));
    return std::unique_ptr<HelperFile>(std::move(audio));
}

}  // namespace vybeg
