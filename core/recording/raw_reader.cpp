#include "core/recording/raw_reader.h"

#include "core/base/number_text.h"
#include "core/recording/byte_order.h"
#include "core/recording/selection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t chunk_bytes = std::int64_t{1} << 20;
constexpr int most_channels = 4096;

int bytes_per_sample(RawType type) {
    switch (type) {
        case RawType::i16: return 2;
        case RawType::i32:
        case RawType::f32: return 4;
        case RawType::f64: return 8;
    }
    return 0;
}

std::string type_text(RawType type) {
    switch (type) {
        case RawType::i16: return "16 bit integer";
        case RawType::i32: return "32 bit integer";
        case RawType::f32: return "32 bit float";
        case RawType::f64: return "64 bit float";
    }
    return "";
}

double load_sample(const char* bytes, const RawLayout& layout) {
    switch (layout.type) {
        case RawType::i16: return load<std::int16_t>(bytes, layout.big_endian);
        case RawType::i32: return load<std::int32_t>(bytes, layout.big_endian);
        case RawType::f32: return static_cast<double>(load<float>(bytes, layout.big_endian));
        case RawType::f64: return load<double>(bytes, layout.big_endian);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

class RawSource : public SampleSource {
public:
    RawSource(std::shared_ptr<const FileBytes> file, const OpenOptions& options)
        : file_(std::move(file)),
          layout_(*options.raw),
          sample_bytes_(bytes_per_sample(layout_.type)),
          frame_bytes_(std::int64_t{sample_bytes_} * layout_.channels),
          offset_c_((options.channel_c - 1) * std::int64_t{sample_bytes_}),
          offset_d_((options.channel_d - 1) * std::int64_t{sample_bytes_}),
          frames_(std::max<std::int64_t>(file_->size() - layout_.skip_bytes, 0) / frame_bytes_) {}

    std::int64_t frames() const override { return frames_; }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        const std::int64_t at_once = std::max<std::int64_t>(chunk_bytes / frame_bytes_, 1);
        const auto length = static_cast<std::int64_t>(c.size());
        std::vector<char> bytes(static_cast<std::size_t>(std::min(at_once, length) * frame_bytes_));
        for (std::int64_t done = 0; done < length; done += at_once) {
            const std::int64_t count = std::min(at_once, length - done);
            const std::span<char> chunk(bytes.data(),
                                        static_cast<std::size_t>(count * frame_bytes_));
            const auto got = file_->read(layout_.skip_bytes + (first + done) * frame_bytes_, chunk);
            if (!got) {
                return got.error();
            }
            if (*got < count * frame_bytes_) {
                return file_->error(ErrorCode::file_read_failed,
                                    {"the file became shorter while it was read"});
            }
            for (std::int64_t i = 0; i < count; ++i) {
                const char* frame = chunk.data() + i * frame_bytes_;
                c[static_cast<std::size_t>(done + i)] = sample(frame + offset_c_);
                d[static_cast<std::size_t>(done + i)] = sample(frame + offset_d_);
            }
        }
        return {};
    }

private:
    double sample(const char* bytes) const {
        const double value = load_sample(bytes, layout_) * layout_.scale;
        return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
    }

    std::shared_ptr<const FileBytes> file_;
    RawLayout layout_;
    int sample_bytes_;
    std::int64_t frame_bytes_;
    std::int64_t offset_c_;
    std::int64_t offset_d_;
    std::int64_t frames_;
};

Status check_layout(const RawLayout& layout) {
    if (layout.channels < 1 || layout.channels > most_channels) {
        return Error{ErrorCode::setting_invalid,
                     "",
                     {"--raw-channels", std::to_string(layout.channels),
                      "it must lie between 2 and " + std::to_string(most_channels)}};
    }
    if (layout.skip_bytes < 0) {
        return Error{ErrorCode::setting_invalid,
                     "",
                     {"--skip", integer_text(layout.skip_bytes), "it must be 0 or more bytes"}};
    }
    if (!std::isfinite(layout.scale) || layout.scale == 0) {
        return Error{ErrorCode::setting_invalid,
                     "",
                     {"--scale", short_text(layout.scale), "it must be a number other than 0"}};
    }
    return {};
}

}  // namespace

Result<Recording> open_raw(std::shared_ptr<const FileBytes> file, const OpenOptions& options) {
    const RawLayout& layout = *options.raw;
    if (const Status status = check_layout(layout); !status) {
        return status.error();
    }
    if (const Status status = check_channels(*file, layout.channels, options); !status) {
        return status.error();
    }
    const auto rate = choose_rate(*file, {}, options);
    if (!rate) {
        return rate.error();
    }
    Recording recording;
    recording.path = file->path();
    recording.format = "raw, " + type_text(layout.type) +
                       (layout.big_endian ? ", big endian, " : ", little endian, ") +
                       std::to_string(layout.channels) + " channels";
    recording.rate_hz = rate->hz;
    recording.rate_from = rate->from;
    recording.channels = numbered_channels(layout.channels);
    recording.channel_c = options.channel_c;
    recording.channel_d = options.channel_d;
    recording.source = std::make_shared<RawSource>(file, options);
    if (const Status status = check_frames(*file, recording.frames()); !status) {
        return status.error();
    }
    return recording;
}

}  // namespace vybeg
