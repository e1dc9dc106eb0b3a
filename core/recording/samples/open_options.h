#pragma once

#include "core/recording/samples/text_choice.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

enum class RawType { i16, i32, f32, f64 };

// Layout of headerless interleaved samples (--raw and its companions).
struct RawLayout {
    RawType type = RawType::i16;
    bool big_endian = false;
    int channels = 2;
    std::int64_t skip_bytes = 0;

    friend bool operator==(const RawLayout&, const RawLayout&) = default;
};

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

    friend bool operator==(const OpenOptions&, const OpenOptions&) = default;
};

}  // namespace vybeg
