#include "core/recording/audio/plain_audio.h"

#include "core/recording/samples/column_source.h"

#include <cmath>
#include <optional>
#include <vector>

namespace vybeg {
namespace {

struct Plain {
    NumberType type;
    Scale scale{};  // integers are fractions of full scale
};

std::optional<Plain> plain_samples(int format) {
    switch (format & SF_FORMAT_SUBMASK) {
        case SF_FORMAT_PCM_U8: return Plain{NumberType::u8, {0x1p-7, -1}};
        case SF_FORMAT_PCM_16: return Plain{NumberType::i16, {0x1p-15, 0}};
        case SF_FORMAT_PCM_24: return Plain{NumberType::i24, {0x1p-23, 0}};
        case SF_FORMAT_PCM_32: return Plain{NumberType::i32, {0x1p-31, 0}};
        case SF_FORMAT_FLOAT: return Plain{NumberType::f32};
        case SF_FORMAT_DOUBLE: return Plain{NumberType::f64};
        default: return std::nullopt;
    }
}

bool is_wav(int format) {
    switch (format & SF_FORMAT_TYPEMASK) {
        case SF_FORMAT_WAV:
        case SF_FORMAT_WAVEX:
        case SF_FORMAT_RF64:
        case SF_FORMAT_W64: return true;
        default: return false;
    }
}

bool same_sample(double plain, double decoded) {
    return plain == decoded || (std::isnan(plain) && !std::isfinite(decoded));
}

// Whether the frame equals that of the decoder.
bool agrees(const SampleSource& source, AudioDecoder& decoder, std::int64_t frame,
            const OpenOptions& options) {
    std::vector<double> decoded(static_cast<std::size_t>(decoder.info().channels));
    double c = 0;
    double d = 0;
    return decoder.read(frame, decoded) && source.read(frame, {&c, 1}, {&d, 1}) &&
           same_sample(c, decoded[static_cast<std::size_t>(options.channel_c - 1)]) &&
           same_sample(d, decoded[static_cast<std::size_t>(options.channel_d - 1)]);
}

}  // namespace

std::shared_ptr<const SampleSource> plain_audio(std::shared_ptr<const FileBytes> file,
                                                const AudioExtent& extent, AudioDecoder& decoder,
                                                std::int64_t frames, const OpenOptions& options) {
    const SF_INFO& info = decoder.info();
    const auto plain = plain_samples(info.format);
    if (!plain || !is_wav(info.format) || extent.samples_at == 0) {
        return nullptr;
    }
    const std::int64_t width = bytes_of(plain->type);
    const std::int64_t stride = width * info.channels;
    if (frames > (file->size() - extent.samples_at) / stride) {
        return nullptr;
    }
    const bool big_endian = (info.format & SF_FORMAT_ENDMASK) == SF_ENDIAN_BIG;
    const auto bytes = file_part(file, 0, file->size());
    const auto column = [&](int channel) {
        const std::int64_t offset = extent.samples_at + (channel - 1) * width;
        return SampleColumn{
            bytes, plain->type, {even_run(frames, offset, stride, big_endian)}, plain->scale};
    };
    auto source = column_source(column(options.channel_c), column(options.channel_d));
    const bool is_so =
        agrees(*source, decoder, 0, options) && agrees(*source, decoder, frames - 1, options);
    return is_so ? source : nullptr;
}

}  // namespace vybeg
