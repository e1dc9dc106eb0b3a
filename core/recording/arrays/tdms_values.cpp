#include "core/recording/arrays/tdms_values.h"

#include <algorithm>
#include <chrono>
#include <string_view>
#include <vector>

namespace vybeg {
namespace {

std::string padded(std::int64_t number, std::size_t digits) {
    std::string text = std::to_string(number);
    return text.size() < digits ? std::string(digits - text.size(), '0') + text : text;
}

}  // namespace

std::optional<NumberType> tdms_number(std::uint32_t type) {
    switch (type) {
        case 0x01: return NumberType::i8;
        case 0x02: return NumberType::i16;
        case 0x03: return NumberType::i32;
        case 0x04: return NumberType::i64;
        case 0x05: return NumberType::u8;
        case 0x06: return NumberType::u16;
        case 0x07: return NumberType::u32;
        case 0x08: return NumberType::u64;
        case 0x09:
        case 0x19: return NumberType::f32;  // 0x19 and 0x1A: with a unit
        case 0x0A:
        case 0x1A: return NumberType::f64;
        default: return std::nullopt;
    }
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

std::string tdms_time_text(std::int64_t seconds, std::uint64_t fraction) {
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

std::optional<TdmsPath> tdms_path(const std::string& path) {
    if (path == "/") {
        return TdmsPath{};
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
    return TdmsPath{names[0], names.size() == 2 ? names[1] : ""};
}

}  // namespace vybeg
