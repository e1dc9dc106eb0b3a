#include "core/recording/audio/audio_reader.h"

#include "core/base/guarded.h"
#include "core/base/number_text.h"
#include "core/recording/audio/audio_decoder.h"
#include "core/recording/audio/audio_extent.h"
#include "core/recording/audio/plain_audio.h"
#include "core/recording/samples/reader_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr std::int64_t chunk_samples = std::int64_t{1} << 16;

class AudioSource : public SampleSource {
public:
    AudioSource(std::shared_ptr<const FileBytes> file, std::vector<HeaderPatch> patches,
                int channels, std::int64_t frames, const OpenOptions& options)
        : file_(std::move(file)),
          patches_(std::move(patches)),
          channels_(channels),
          channel_c_(options.channel_c - 1),
          channel_d_(options.channel_d - 1),
          frames_(frames) {}

    std::int64_t frames() const override { return frames_; }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        const std::int64_t at_once = std::max<std::int64_t>(chunk_samples / channels_, 1);
        const auto length = static_cast<std::int64_t>(c.size());
        std::vector<double> samples(
            static_cast<std::size_t>(std::min(at_once, length) * channels_));
        for (std::int64_t done = 0; done < length; done += at_once) {
            const std::int64_t count = std::min(at_once, length - done);
            const std::span<double> chunk(samples.data(),
                                          static_cast<std::size_t>(count * channels_));
            if (const Status status = decode(first + done, chunk); !status) {
                return status;
            }
            for (std::int64_t i = 0; i < count; ++i) {
                const double* frame = chunk.data() + i * channels_;
                c[static_cast<std::size_t>(done + i)] = present(frame[channel_c_]);
                d[static_cast<std::size_t>(done + i)] = present(frame[channel_d_]);
            }
        }
        return {};
    }

private:
    static double present(double sample) {
        return std::isfinite(sample) ? sample : std::numeric_limits<double>::quiet_NaN();
    }

    Status decode(std::int64_t first, std::span<double> samples) const {
        const auto decoder = decoder_.hold();
        if (!*decoder) {
            auto opened = AudioDecoder::open(file_, patches_);
            if (!opened) {
                return opened.error();
            }
            *decoder = std::move(*opened);
        }
        const Status status = (*decoder)->read(first, samples);
        if (!status) {
            decoder->reset();  // libFLAC never recovers from a failed seek
        }
        return status;
    }

    std::shared_ptr<const FileBytes> file_;
    std::vector<HeaderPatch> patches_;
    int channels_;
    int channel_c_;
    int channel_d_;
    std::int64_t frames_;
    Guarded<std::unique_ptr<AudioDecoder>> decoder_;
};

// Number of frames that can be decoded from the start. If the last frame of the header cannot be
// decoded, only decoding shows the number.
Result<std::int64_t> count_frames(const std::shared_ptr<const FileBytes>& file,
                                  const std::vector<HeaderPatch>& patches, const JobControl& job) {
    std::int64_t frames = 0;
    // In large steps to the damage, then frame by frame up to it.
    for (const std::int64_t step : {std::int64_t{4096}, std::int64_t{1}}) {
        auto decoder = AudioDecoder::open(file, patches);
        if (!decoder) {
            return decoder.error();
        }
        const SF_INFO& info = (*decoder)->info();
        std::vector<double> samples(static_cast<std::size_t>(step * info.channels));
        while (frames < info.frames) {
            if (job.cancelled()) {
                return file->error(ErrorCode::interrupted);
            }
            const std::int64_t count = std::min(step, info.frames - frames);
            const std::span<double> chunk(samples.data(),
                                          static_cast<std::size_t>(count * info.channels));
            if (!(*decoder)->read(frames, chunk)) {
                break;
            }
            frames += count;
        }
    }
    return frames;
}

struct Extent {
    std::int64_t promised = 0;
    std::int64_t present = 0;
};

Result<Extent> find_extent(const std::shared_ptr<const FileBytes>& file, AudioDecoder& decoder,
                           const AudioExtent& header, const JobControl& job) {
    const std::int64_t frames = decoder.info().frames;
    Extent extent{std::max(header.promised_frames.value_or(0), frames), frames};
    std::vector<double> last(static_cast<std::size_t>(decoder.info().channels));
    if (frames > 0 && !decoder.read(frames - 1, last)) {
        const auto counted = count_frames(file, header.patches, job);
        if (!counted) {
            return counted.error();
        }
        extent.present = *counted;
    }
    return extent;
}

}  // namespace

Result<Recording> open_audio(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                             const JobControl& job) {
    const auto header = audio_extent(*file);
    if (!header) {
        return header.error();
    }
    auto opened = AudioDecoder::open(file, header->patches);
    if (!opened) {
        return opened.error();
    }
    AudioDecoder& decoder = **opened;
    const SF_INFO info = decoder.info();
    if (const Status status = check_channels(*file, info.channels, options); !status) {
        return status.error();
    }
    const SampleRate own{header->rate_is_zero ? 0.0 : static_cast<double>(info.samplerate),
                         RateOrigin::file};
    // Checked before frames are counted.
    if (const auto rate = choose_rate(*file, own, options); !rate) {
        return rate.error();
    }
    const auto extent = find_extent(file, decoder, *header, job);
    if (!extent) {
        return extent.error();
    }
    FoundSamples found;
    found.format = {FormatPart::name(decoder.container()), FormatPart::words(decoder.sample_type()),
                    FormatPart::channels(info.channels)};
    found.channels = numbered_channels(info.channels);
    found.own_rate = own;
    found.start = decoder.start();
    found.frames = extent->present;
    found.promised_frames = extent->promised;
    found.never_closed = header->never_closed;
    if (found.frames > 0) {
        found.source = plain_audio(file, *header, decoder, found.frames, options);
        if (!found.source) {
            found.source = std::make_shared<AudioSource>(file, header->patches, info.channels,
                                                         found.frames, options);
        }
    }
    return complete_recording(*file, std::move(found), options);
}

}  // namespace vybeg
