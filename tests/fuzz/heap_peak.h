#pragma once

#include <cstdint>

namespace vybeg::fuzz {

// Bytes on the heap, of whoever allocated them: our code, libsndfile, zlib, HDF5. A program that
// links heap_peak.cpp counts them; under AddressSanitizer through its own hooks.

// From here on the peak counts anew.
void start_heap_peak();

// The most that was held at once since then, beyond what was held then.
std::int64_t heap_peak();

}  // namespace vybeg::fuzz
