#include "core/recording/arrays/tdms_metadata.h"

#include "core/recording/bytes/number_type.h"
#include "core/recording/bytes/text_encoding.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>
#include <string_view>
#include <vector>

namespace vybeg {
namespace {

std::string padded(std::int64_t number, std::size_t digits) {
    std::string text = std::to_string(number);
    return text.size() < digits ? std::string(digits - text.size(), '0') + text : text;
}

// A TDMS time stamp as "2020-03-01T12:34:56.789Z". It counts seconds from 1904 on, and fractions of
// 2^-64 s. Empty outside the years 1 to 9999.
std::string time_text(std::int64_t seconds, std::uint64_t fraction) {
    using namespace std::chrono;
    constexpr std::int64_t day = 86400;
    constexpr std::int64_t farthest_days = 4'000'000;
    const std::int64_t days_after = seconds / day - (seconds % day < 0 ? 1 : 0);
    if (days_after < -farthest_days || days_after > farthest_days) {
        return {};
    }
    const year_month_day date(sys_days(year(1904) / January / 1) + days(days_after));
    const int in_year = static_cast<int>(date.year());
    if (in_year < 1 || in_year > 9999) {
        return {};
    }
    const std::int64_t in_day = seconds - days_after * day;
    // Rounded to the nearest, because the fraction of .789 s lies just below it.
    const std::uint64_t milliseconds =
        std::min<std::uint64_t>(((fraction >> 32) * 1000 + (1u << 31)) >> 32, 999);
    return padded(in_year, 4) + "-" + padded(static_cast<unsigned>(date.month()), 2) + "-" +
           padded(static_cast<unsigned>(date.day()), 2) + "T" + padded(in_day / 3600, 2) + ":" +
           padded(in_day / 60 % 60, 2) + ":" + padded(in_day % 60, 2) + "." +
           padded(static_cast<std::int64_t>(milliseconds), 3) + "Z";
}

constexpr std::uint64_t most_values = std::uint64_t{1} << 40;  // of an object in a chunk
constexpr std::int64_t widest_row = std::int64_t{1} << 20;     // bytes of all buffers' rows

// Raw indices of DAQmx. The published layout numbers digital lines 0x1369, the driver 0x126A.
constexpr std::uint32_t format_changing = 0x1269;
constexpr std::uint32_t digital_lines = 0x126A;
constexpr std::uint32_t digital_lines_as_published = 0x1369;

Error impossible() {
    return {ErrorCode::format_damaged,
            "",
            {"TDMS", words(VYBEG_MESSAGE(
                         "Words", "the raw data of a channel cannot be as its index says"))}};
}

// Type of a scaler, which has a separate numbering; empty for times and unknown types.
std::optional<NumberType> scaler_type(std::uint32_t code) {
    constexpr std::array types{NumberType::u8,  NumberType::i8,  NumberType::u16, NumberType::i16,
                               NumberType::u32, NumberType::i32, NumberType::u64, NumberType::i64,
                               NumberType::f32, NumberType::f64};
    return code < types.size() ? std::optional(types[code]) : std::nullopt;
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

Status take_daqmx_index(TdmsMetadata& metadata, bool is_digital, TdmsRawIndex& index) {
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

std::optional<NumberType> tdms_number(std::uint32_t type) {
    // From 1 on; 0x19 and 0x1A are floats with a unit.
    constexpr std::array types{NumberType::i8,  NumberType::i16, NumberType::i32, NumberType::i64,
                               NumberType::u8,  NumberType::u16, NumberType::u32, NumberType::u64,
                               NumberType::f32, NumberType::f64};
    const std::uint32_t place = (type == 0x19 || type == 0x1A ? type - 0x10 : type) - 1;
    return place < types.size() ? std::optional(types[place]) : std::nullopt;
}

std::optional<int> tdms_bytes(std::uint32_t type) {
    if (const auto number = tdms_number(type)) {
        return bytes_of(*number);
    }
    switch (type) {
        case 0x00: return 1;  // void
        case 0x21: return 1;  // boolean
        case 0x0B:
        case 0x1B: return 16;  // extended float
        case tdms_time: return 16;
        case 0x08000C: return 8;   // complex, two 32 bit floats
        case 0x10000D: return 16;  // complex, two 64 bit floats
        default: return std::nullopt;
    }
}

std::optional<TdmsObject> tdms_object(const std::string& path) {
    if (path == "/") {
        return TdmsObject{};
    }
    std::vector<std::string> names;
    std::string_view rest = path;
    while (rest.starts_with("/'")) {
        rest.remove_prefix(2);
        std::string name;
        for (bool open = true; open;) {
            const std::size_t quote = rest.find('\'');
            if (quote == rest.npos) {
                return std::nullopt;
            }
            name += rest.substr(0, quote);
            rest.remove_prefix(quote + 1);
            open = rest.starts_with('\'');
            if (open) {
                name += '\'';
                rest.remove_prefix(1);
            }
        }
        names.push_back(name);
    }
    if (!rest.empty() || names.empty() || names.size() > 2) {
        return std::nullopt;
    }
    return TdmsObject{to_utf8(names[0]), names.size() == 2 ? to_utf8(names[1]) : ""};
}

std::optional<double> TdmsObject::number(std::string_view property) const {
    const auto found = properties.find(property);
    return found == properties.end() ? std::nullopt : found->second.number;
}

std::string TdmsObject::text(std::string_view property) const {
    const auto found = properties.find(property);
    return found == properties.end() ? "" : found->second.text;
}

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
        return TdmsValue{std::nullopt, time_text(seconds, seconds_first ? second : first)};
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

Status take_raw_index(TdmsMetadata& metadata, std::uint32_t length, TdmsRawIndex& index) {
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
        return Error{ErrorCode::format_unsupported,
                     "",
                     {"TDMS", words(VYBEG_MESSAGE("Words", "values of the type %1"),
                                    {count_arg(index.type)})}};
    }
    index.count = static_cast<std::int64_t>(count);
    index.bytes = static_cast<std::int64_t>(bytes);
    return {};
}

}  // namespace vybeg
