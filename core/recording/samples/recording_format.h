#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// One part of what a recording's file is made of.
struct FormatPart {
    // A name ("WAV") reads the same in every language; words ("64 bit float") are translated by the
    // desktop program (context "Format"); channels and columns are counts.
    enum class Kind : std::uint8_t { name, words, channels, columns };

    Kind kind = Kind::name;
    std::string text;        // of a name or words
    std::int64_t count = 0;  // of channels or columns

    static FormatPart name(std::string text) { return {Kind::name, std::move(text), 0}; }
    // E.g. words(VYBEG_MESSAGE("Format", "decimal comma")).
    static FormatPart words(std::string text) { return {Kind::words, std::move(text), 0}; }
    static FormatPart channels(std::int64_t count) { return {Kind::channels, {}, count}; }
    static FormatPart columns(std::int64_t count) { return {Kind::columns, {}, count}; }

    friend bool operator==(const FormatPart&, const FormatPart&) = default;
};

using RecordingFormat = std::vector<FormatPart>;

FormatPart byte_order_part(bool big_endian);

// E.g. "WAV, 64 bit float, 2 channels", "text, 3 columns, comma".
std::string english(const RecordingFormat& format);

}  // namespace vybeg
