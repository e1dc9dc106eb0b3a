#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace vybeg {

// The header that stands before every variable of a MAT file of level 4.
struct Mat4Header {
    std::int64_t rows = 0;
    std::int64_t columns = 0;
    std::int64_t name_bytes = 0;  // with the zero at its end
    std::int64_t data_bytes = 0;
};

inline constexpr int mat4_header_bytes = 20;

// Nothing where the bytes are fewer or cannot be such a header: level 4 has no signature, and most
// combinations of its five numbers are impossible.
std::optional<Mat4Header> mat4_header(std::string_view bytes);

// Whether a file of `size` bytes that begins with `head` is one of level 4: a possible header, a
// name that is one, and an array that the file has room for, at least a part of it.
bool is_mat4(std::string_view head, std::int64_t size);

bool is_mat5(std::string_view head);

}  // namespace vybeg
