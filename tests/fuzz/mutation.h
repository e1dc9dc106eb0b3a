#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vybeg::fuzz {

// Ways in which a file goes wrong.
enum class Damage {
    cut,      // ends at any byte
    bits,     // one to three wrong bits
    bytes,    // up to 16 bytes of anything
    length,   // a number of 2, 4 or 8 bytes that no length can be: 2^63, all ones, 0, ...
    real,     // a number of 4 or 8 bytes that no rate can be: NaN, infinite, 1e300, -1, ...
    digits,   // a number in letters becomes one of those
    moved,    // a segment stands in another place, or twice
    missing,  // a segment is left out
    zeros     // a segment of zeros
};
inline constexpr std::array<const char*, 9> damage_names{
    "cut", "bits", "bytes", "length", "real", "digits", "moved", "missing", "zeros"};

struct Mutation {
    std::string bytes;
    std::string what;  // the damages that it has, e.g. "bits, length"
};

// One of the files with one or two damages, mostly near its beginning and its end, where headers
// and directories are. The same seed makes the same file.
Mutation mutated(const std::vector<std::string>& files, std::uint64_t seed);

}  // namespace vybeg::fuzz
