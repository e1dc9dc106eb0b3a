#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

// Pieces of a MAT file of level 5, to be written one behind the other. libmatio would write a
// variable in one piece and ignore the stop token and a full disk.
namespace vybeg {

// What stands before the numbers of a NumPy array: `type` as "<f8", `shape` as "5, 2" or "5,".
std::string npy_head(std::string_view type, std::string_view shape);

// The lengths in such a file are 32 bit counts of bytes.
inline constexpr std::int64_t most_mat_bytes = (std::int64_t{1} << 32) - 128;
// Of a column of doubles, with its head.
inline constexpr std::int64_t most_mat_rows = most_mat_bytes / 8;

std::string mat_file_head();

// The head of a column of doubles, up to its first byte of data. Precondition: rows <=
// most_mat_rows.
std::string mat_column_head(const std::string& name, std::int64_t rows);

// The head of a column of cells that take `bytes` in all, at most most_mat_bytes.
std::string mat_cells_head(const std::string& name, std::int64_t rows, std::int64_t bytes);

// A cell with a text in UTF-8; without characters a matrix of 0 x 0.
std::string mat_text_cell(const std::string& text);

static_assert(std::endian::native == std::endian::little,
              "numbers go into NPY, NPZ, MAT and HDF5 files as they lie in memory");

template <class... Numbers>
void append_bytes(std::string& bytes, Numbers... numbers) {
    const auto append = [&bytes](auto number) {
        const auto raw = std::bit_cast<std::array<char, sizeof number>>(number);
        bytes.append(raw.data(), raw.size());
    };
    (append(numbers), ...);
}

inline std::string_view bytes_of(std::span<const double> numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace vybeg
