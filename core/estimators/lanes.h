#pragma once

#include <array>
#include <cstddef>

// Windows that are worked on side by side in the processor's vectors. Eight is for sources only:
// functions of it must be inlined, and what calls them be VYBEG_DISPATCHED.

// Compiled for these processors, the best of which is chosen when the program starts: any x86-64,
// AVX2 with FMA, and AVX-512. Not under AddressSanitizer: the choice would come before it is ready.
#if defined(__x86_64__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define VYBEG_DISPATCHED \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define VYBEG_DISPATCHED
#endif
#define VYBEG_INLINED __attribute__((always_inline))

namespace vybeg {

inline constexpr std::size_t series_lanes = 8;
using Lanes = std::array<double, series_lanes>;

// Vectors are passed between inlined functions only: how they would be passed otherwise is nobody's
// concern.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

// Eight numbers that the compiler keeps in one, two or four registers.
using Eight = double __attribute__((vector_size(64)));

VYBEG_INLINED inline Eight load(const double* from) {
    Eight value;
    __builtin_memcpy(&value, from, sizeof value);
    return value;
}

VYBEG_INLINED inline Eight load(const Lanes& from) {
    return load(from.data());
}

VYBEG_INLINED inline void store(Eight value, Lanes& to) {
    __builtin_memcpy(to.data(), &value, sizeof value);
}

// sum_k coefficient(k) x^k in each lane.
template <std::size_t orders, class Coefficient>
VYBEG_INLINED inline Eight polynomial(Eight x, Coefficient coefficient) {
    Eight value = coefficient(orders - 1);
    for (std::size_t k = orders - 1; k-- > 0;) {
        value = value * x + coefficient(k);
    }
    return value;
}

// Value, slope and curvature of a power series at x, in each lane.
struct Bent {
    Eight value;
    Eight slope;
    Eight bend;
};

template <std::size_t orders, class Coefficient>
VYBEG_INLINED inline Bent series_at(Eight x, Coefficient coefficient) {
    Bent sum{coefficient(orders - 1), Eight{}, Eight{}};
    for (std::size_t k = orders - 1; k-- > 0;) {
        sum.bend = sum.bend * x + sum.slope;
        sum.slope = sum.slope * x + sum.value;
        sum.value = sum.value * x + coefficient(k);
    }
    sum.bend *= 2;
    return sum;
}

#pragma GCC diagnostic pop

}  // namespace vybeg
