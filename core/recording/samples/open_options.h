#pragma once

#include "core/base/describe.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// Options of a text file (--delimiter and its companions); other properties are guessed from its
// content.
struct TextChoice {
    std::optional<char> delimiter{};              // as in TextFormat
    std::optional<bool> decimal_comma{};          // otherwise a point
    std::optional<std::int64_t> lines_to_skip{};  // above the first row
    std::optional<int> time_column{};     // from 1, counting every column of the file; 0: none
    std::optional<double> time_unit_s{};  // seconds per unit of the time column

    friend bool operator==(const TextChoice&, const TextChoice&) = default;
};

template <class Archive, Described<TextChoice> Owner>
void describe(Archive&& archive, Owner& text) {
    archive("delimiter", text.delimiter);
    archive("decimal_comma", text.decimal_comma);
    archive("lines_to_skip", text.lines_to_skip);
    archive("time_column", text.time_column);
    archive("time_unit_s", text.time_unit_s);
}

enum class RawType { i16, i32, f32, f64 };
inline constexpr std::array<const char*, 4> raw_type_names{"i16", "i32", "f32", "f64"};

// Layout of headerless interleaved samples (--raw and its companions).
struct RawLayout {
    RawType type = RawType::i16;
    bool big_endian = false;
    int channels = 2;
    std::int64_t skip_bytes = 0;

    friend bool operator==(const RawLayout&, const RawLayout&) = default;
};

template <class Archive, Described<RawLayout> Owner>
void describe(Archive&& archive, Owner& raw) {
    archive.word("type", raw.type, raw_type_names);
    archive("big_endian", raw.big_endian);
    archive("channels", raw.channels);
    archive("skip_bytes", raw.skip_bytes);
}

struct OpenOptions {
    std::optional<double> rate_hz{};  // used if the file has no rate
    int channel_c = 1;                // from 1; a time column does not count
    int channel_d = 2;
    std::optional<RawLayout> raw{};  // read the file as raw samples in any case
    // Names of the variables of C, D and, third, the rate in a file of several variables (NPZ, MAT,
    // HDF5). D's name is omitted, or empty before a rate, if the variable of C contains both
    // channels. Empty: chosen by the reader.
    std::vector<std::string> variables{};
    std::optional<TextChoice> text{};  // read the file as text in any case
    std::string unit{};                // of the samples; empty: that of the file
    double scale = 1;                  // recording units per count or per unit of the file
    // The file of channel D, where the recording's own holds C; empty: the same one. Of a file with
    // one channel it is this one; otherwise channel_c counts in C's file and channel_d in D's.
    std::string channel_d_file{};
    std::vector<std::string> join{};  // the files of the recording's further pieces, in their order

    friend bool operator==(const OpenOptions&, const OpenOptions&) = default;
};

template <class Archive, Described<OpenOptions> Owner>
void describe(Archive&& archive, Owner& open) {
    const OpenOptions usual;
    archive("rate_hz", open.rate_hz);
    archive("channel_c", open.channel_c);
    archive("channel_d", open.channel_d);
    archive("raw", open.raw);
    archive("variables", open.variables, usual.variables);
    archive("text", open.text);
    archive("unit", open.unit, usual.unit);
    archive("scale", open.scale, usual.scale);
    archive("channel_d_file", open.channel_d_file, usual.channel_d_file);
    archive("join", open.join, usual.join);
}

}  // namespace vybeg
