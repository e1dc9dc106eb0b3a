#pragma once

#include "core/output/output_file.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// The header before the numbers of a NumPy array: `type` as "<f8", `shape` as "5, 2" or "5,".
std::string npy_head(std::string_view type, std::string_view shape);

// Pieces of a MAT file of level 5, to be written one after the other: libmatio would write a
// variable in one piece and ignore the stop token and a full disk. The lengths in such a file are
// 32 bit counts of bytes.
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

// Writes a ZIP archive whose members are not packed, with the ZIP64 fields where a member, its
// place or the archive is beyond 32 bits. Members have no time of day, so that equal content makes
// equal files. Errors: output_failed, interrupted.
class StoredZip {
public:
    // `file` must outlive it. `most_of_32_bits`: the largest number that needs no ZIP64 field;
    // tests lower it.
    explicit StoredZip(OutputFile& file, std::uint64_t most_of_32_bits = 0xFFFFFFFE)
        : file_(file), most_(most_of_32_bits) {}

    // Begins a member; then the caller writes its `size` bytes into the file. `crc`: theirs, as
    // zlib computes it.
    Status begin(const std::string& name, std::uint64_t size, std::uint32_t crc);
    // Writes the directory.
    Status finish();

private:
    struct Member {
        std::string name;
        std::uint64_t size = 0;
        std::uint64_t place = 0;
        std::uint32_t crc = 0;
    };
    std::uint32_t field(std::uint64_t number) const;
    // The fields that local headers and the directory share, from the version to the length of the
    // name; `extra`: what the ZIP64 fields hold.
    std::string common_fields(const Member& member, std::uint16_t extra_bytes) const;
    std::string extra(const Member& member, bool with_place) const;

    OutputFile& file_;
    std::uint64_t most_;
    std::vector<Member> members_;
    std::uint64_t at_ = 0;  // bytes written, with those of the member that was begun
};

}  // namespace vybeg
