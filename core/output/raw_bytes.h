#pragma once

#include <array>
#include <bit>
#include <span>
#include <string>
#include <string_view>

namespace vybeg {

static_assert(std::endian::native == std::endian::little,
              "numbers go into NPY, NPZ, MAT and HDF5 files as they lie in memory");

template <class Number>
void append_bytes(std::string& bytes, Number number) {
    const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    bytes.append(raw.data(), raw.size());
}

inline std::string_view bytes_of(std::span<const double> numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace vybeg
