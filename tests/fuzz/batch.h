#pragma once

#include "tests/fuzz/mutation.h"
#include "tests/fuzz/trial.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

// Files that are tried in processes that may die of them, many in each.
namespace vybeg::fuzz {

struct BatchCount {
    std::array<std::uint64_t, 3> outcomes{};  // by Outcome
    std::uint64_t deaths = 0;                 // of a library
    std::uint64_t endless = 0;                // files that took more than 2 s, and were given up
    std::vector<std::string> faults;          // what no file may bring about, with its seed
    double slowest_s = 0;                     // processor time of one file
};

// Tries the files file_of(first), file_of(first + 1), ... A process has 2 s of processor time for
// each of them, and the memory of a vybeg-reader: the file's size and 64 MB beyond what it holds;
// under AddressSanitizer, which takes all addresses, a single allocation has 64 MB. A process that
// dies is followed by another with the next file. Its death is a fault where a sanitizer names our
// own code, and a death of the library otherwise.
BatchCount try_batch(std::uint64_t first, std::uint64_t count,
                     const std::function<Mutation(std::uint64_t)>& file_of,
                     const TryFile& try_file);

}  // namespace vybeg::fuzz
