#include "core/recording/arrays/raw_reader.h"

#include "core/base/message_arg.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/samples/reader_rules.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vybeg {
namespace {

std::int64_t frame_count(const FileBytes& file, const RawLayout& layout) {
    const std::int64_t stride = std::int64_t{bytes_of(number_type(layout.type))} * layout.channels;
    return std::max<std::int64_t>(file.size() - layout.skip_bytes, 0) / stride;
}

// Precondition: a frame or more, so that the samples begin inside of the file.
std::shared_ptr<const SampleSource> raw_source(const std::shared_ptr<const FileBytes>& file,
                                               const OpenOptions& options, std::int64_t frames) {
    const RawLayout& layout = *options.raw;
    const NumberType type = number_type(layout.type);
    const std::int64_t width = bytes_of(type);
    const std::int64_t stride = width * layout.channels;
    const auto bytes = file_part(file, 0, file->size());
    const auto column = [&](int channel) {
        const std::int64_t offset = layout.skip_bytes + (channel - 1) * width;
        return SampleColumn{
            bytes, type, {even_run(frames, offset, stride, layout.big_endian)}, 1, 0};
    };
    return column_source(column(options.channel_c), column(options.channel_d));
}

}  // namespace

NumberType number_type(RawType type) {
    // In the order of RawType.
    constexpr std::array types{NumberType::i16, NumberType::i32, NumberType::f32, NumberType::f64};
    return types.at(static_cast<std::size_t>(type));
}

Result<Recording> open_raw(std::shared_ptr<const FileBytes> file, const OpenOptions& options) {
    const RawLayout& layout = *options.raw;
    TRY(check_layout(layout));
    TRY(check_channels(*file, layout.channels, options));
    FoundSamples found;
    found.format = {FormatPart::words(VYBEG_MESSAGE("Format", "raw")),
                    FormatPart::words(name_of(number_type(layout.type))),
                    byte_order_part(layout.big_endian), FormatPart::channels(layout.channels)};
    found.channels = numbered_channels(layout.channels);
    found.present_frames = frame_count(*file, layout);
    if (found.present_frames > 0) {
        found.source = raw_source(file, options, found.present_frames);
    }
    return complete_recording(*file, std::move(found), options);
}

}  // namespace vybeg
