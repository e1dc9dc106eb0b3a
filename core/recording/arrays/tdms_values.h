#pragma once

#include "core/recording/bytes/number_type.h"

#include <cstdint>
#include <optional>
#include <string>

namespace vybeg {

inline constexpr std::uint32_t tdms_string = 0x20;
inline constexpr std::uint32_t tdms_time = 0x44;

// Number type of a TDMS type, if samples can have it.
std::optional<NumberType> tdms_number(std::uint32_t type);

// Bytes of one value of a TDMS type; empty for strings and unknown types.
std::optional<int> tdms_bytes(std::uint32_t type);

// A TDMS time stamp as "2020-03-01T12:34:56.789Z". It counts seconds from 1904 on, and fractions of
// 2^-64 s. Empty outside the years 1 to 9999.
std::string tdms_time_text(std::int64_t seconds, std::uint64_t fraction);

// Group and channel of an object's path: /'group'/'channel', a quote within a name written twice;
// "/" is the file itself, without either. Empty for other texts.
struct TdmsPath {
    std::string group;
    std::string channel;
};
std::optional<TdmsPath> tdms_path(const std::string& path);

}  // namespace vybeg
