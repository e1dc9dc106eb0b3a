#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>

namespace vybeg {

// Number at `bytes` in the given byte order, for any alignment.
template <class Number>
Number load(const char* bytes, bool big_endian) {
    std::array<char, sizeof(Number)> copy;
    std::memcpy(copy.data(), bytes, copy.size());
    if (big_endian != (std::endian::native == std::endian::big)) {
        std::reverse(copy.begin(), copy.end());
    }
    return std::bit_cast<Number>(copy);
}

// The bytes of a number in the given byte order.
template <class Number>
std::string store(Number number, bool big_endian) {
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (big_endian != (std::endian::native == std::endian::big)) {
        std::reverse(bytes.begin(), bytes.end());
    }
    return {bytes.begin(), bytes.end()};
}

}  // namespace vybeg
