#include "core/recording/arrays/tdms_metadata.h"

#include "core/recording/bytes/number_decoding.h"
#include "core/recording/bytes/text_encoding.h"

#include <algorithm>
#include <numeric>

namespace vybeg {
namespace {

constexpr std::uint64_t most_values = std::uint64_t{1} << 40;  // of an object in a chunk
constexpr std::int64_t widest_row = std::int64_t{1} << 20;     // bytes of all buffers' rows

// Raw indices of DAQmx. The published layout numbers digital lines 0x1369, the driver 0x126A.
constexpr std::uint32_t format_changing = 0x1269;
constexpr std::uint32_t digital_lines = 0x126A;
constexpr std::uint32_t digital_lines_as_published = 0x1369;

TdmsRefusal impossible() {
    return {true,
            words(VYBEG_MESSAGE("Words", "the raw data of a channel cannot be as its index says"))};
}

// Type of a scaler, which has a separate numbering; empty for times and unknown types.
std::optional<NumberType> scaler_type(std::uint32_t code) {
    switch (code) {
        case 0: return NumberType::u8;
        case 1: return NumberType::i8;
        case 2: return NumberType::u16;
        case 3: return NumberType::i16;
        case 4: return NumberType::u32;
        case 5: return NumberType::i32;
        case 6: return NumberType::u64;
        case 7: return NumberType::i64;
        case 8: return NumberType::f32;
        case 9: return NumberType::f64;
        default: return std::nullopt;
    }
}

TdmsScaler take_scaler(TdmsMetadata& metadata, bool is_digital) {
    TdmsScaler scaler;
    const auto type = metadata.number<std::uint32_t>();
    scaler.buffer = metadata.number<std::uint32_t>();
    scaler.offset = metadata.number<std::uint32_t>();
    if (is_digital) {
        scaler.offset /= 8;  // in bits
        metadata.bytes(1);   // the bitmap of the sample's format
    } else {
        scaler.type = scaler_type(type);
        metadata.bytes(4);
    }
    scaler.id = metadata.number<std::uint32_t>();
    return scaler;
}

// Whether each scaler lies inside a row of its buffer.
bool fits(const TdmsRawIndex& index) {
    const auto buffers = static_cast<std::int64_t>(index.widths.size());
    return std::accumulate(index.widths.begin(), index.widths.end(), std::int64_t{0}) <=
               widest_row &&
           std::all_of(index.scalers.begin(), index.scalers.end(), [&](const TdmsScaler& scaler) {
               return scaler.buffer < buffers &&
                      scaler.offset + (scaler.type ? bytes_of(*scaler.type) : 1) <=
                          index.widths[static_cast<std::size_t>(scaler.buffer)];
           });
}

std::optional<TdmsRefusal> take_daqmx_index(TdmsMetadata& metadata, bool is_digital,
                                            TdmsRawIndex& index) {
    index.is_daqmx = true;
    index.type = metadata.number<std::uint32_t>();
    const auto dimensions = metadata.number<std::uint32_t>();
    const auto count = metadata.number<std::uint64_t>();
    const auto scalers = metadata.number<std::uint32_t>();
    for (std::uint32_t i = 0; i < scalers && !metadata.ended(); ++i) {
        index.scalers.push_back(take_scaler(metadata, is_digital));
    }
    const auto buffers = metadata.number<std::uint32_t>();
    for (std::uint32_t i = 0; i < buffers && !metadata.ended(); ++i) {
        index.widths.push_back(metadata.number<std::uint32_t>());
    }
    if (metadata.ended() || dimensions != 1 || count > most_values || !fits(index)) {
        return impossible();
    }
    index.count = static_cast<std::int64_t>(count);
    return {};
}

}  // namespace

std::string_view TdmsMetadata::bytes(std::size_t size) {
    if (rest_.size() < size) {
        rest_ = {};
        ended_ = true;
        return {};
    }
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
}

std::optional<TdmsValue> TdmsMetadata::value(std::uint32_t type) {
    if (type == tdms_string) {
        return TdmsValue{std::nullopt, to_utf8(string())};
    }
    if (type == tdms_time) {
        const bool seconds_first = big_endian_;
        const auto first = number<std::uint64_t>();
        const auto second = number<std::uint64_t>();
        const auto seconds = static_cast<std::int64_t>(seconds_first ? first : second);
        return TdmsValue{std::nullopt, tdms_time_text(seconds, seconds_first ? second : first)};
    }
    const auto size = tdms_bytes(type);
    if (!size) {
        return std::nullopt;
    }
    const std::string_view content = bytes(static_cast<std::size_t>(*size));
    TdmsValue value;
    if (const auto number_type = tdms_number(type); number_type && !ended_) {
        double number = 0;
        decode(*number_type, big_endian_, content.data(), *size, {}, {&number, 1});
        value.number = number;
    }
    return value;
}

std::optional<TdmsRefusal> take_raw_index(TdmsMetadata& metadata, std::uint32_t length,
                                          TdmsRawIndex& index) {
    const bool is_digital = length == digital_lines || length == digital_lines_as_published;
    if (is_digital || length == format_changing) {
        return take_daqmx_index(metadata, is_digital, index);
    }
    index.type = metadata.number<std::uint32_t>();
    const auto dimensions = metadata.number<std::uint32_t>();
    const auto count = metadata.number<std::uint64_t>();
    const auto size = index.type == tdms_string ? std::optional(1) : tdms_bytes(index.type);
    const std::uint64_t bytes = index.type == tdms_string
                                    ? metadata.number<std::uint64_t>()
                                    : count * static_cast<std::uint64_t>(size.value_or(0));
    if (metadata.ended() || dimensions != 1 || count > most_values || bytes > 16 * most_values) {
        return impossible();
    }
    if (!size) {
        return TdmsRefusal{
            false, words(VYBEG_MESSAGE("Words", "values of the type %1"), {count_arg(index.type)})};
    }
    index.count = static_cast<std::int64_t>(count);
    index.bytes = static_cast<std::int64_t>(bytes);
    return {};
}

}  // namespace vybeg
