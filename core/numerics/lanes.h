#pragma once

#include "core/base/dispatch.h"

#include <array>
#include <cmath>
#include <cstddef>

// The two widths of a formula: double, for one window, and Vec8, for eight windows side by side in
// the processor's vectors. Formulas are templates on Real, one of the two, and VYBEG_INLINED;
// functions that use them on Vec8 are VYBEG_DISPATCHED. Thus the instructions of each processor
// remain in the function compiled for it.

namespace vybeg {

inline constexpr std::size_t lane_count = 8;
using Lanes = std::array<double, lane_count>;

// Eight numbers that the compiler keeps in one, two or four registers.
using Vec8 = double __attribute__((vector_size(64)));
using Words8 = unsigned long long __attribute__((vector_size(64)));

// Lanes for which a condition holds: all bits of a lane or none.
struct Mask8 {
    Words8 bits;
};

VYBEG_INLINED inline Vec8 load(const double* from) {
    Vec8 value;
    __builtin_memcpy(&value, from, sizeof value);
    return value;
}

VYBEG_INLINED inline Vec8 load(const Lanes& from) {
    return load(from.data());
}

VYBEG_INLINED inline void store(Vec8 value, Lanes& to) {
    __builtin_memcpy(to.data(), &value, sizeof value);
}

// One lane of a struct whose members are all of type Real.
template <template <class> class Struct>
inline Struct<double> lane_of(const Struct<Vec8>& eight, std::size_t lane) {
    constexpr std::size_t members = sizeof(Struct<double>) / sizeof(double);
    static_assert(sizeof(Struct<Vec8>) == members * sizeof(Vec8));
    Struct<double> one;
    const char* from = reinterpret_cast<const char*>(&eight) + lane * sizeof(double);
    char* to = reinterpret_cast<char*>(&one);
    for (std::size_t k = 0; k < members; ++k) {
        __builtin_memcpy(to + k * sizeof(double), from + k * sizeof(Vec8), sizeof(double));
    }
    return one;
}

// Comparisons use the sign bit, because GCC splits comparisons of long vectors into lanes. The
// result for NaN is undefined.
VYBEG_INLINED inline bool negative(double x) {
    return std::signbit(x);
}
VYBEG_INLINED inline Mask8 negative(Vec8 x) {
    return {-((Words8)x >> 63)};
}
template <class A, class B>
VYBEG_INLINED inline auto less(A a, B b) {
    return negative(a - b);
}
template <class Real>
using MaskOf = decltype(negative(Real{}));

VYBEG_INLINED inline Mask8 operator&(Mask8 a, Mask8 b) {
    return {a.bits & b.bits};
}
VYBEG_INLINED inline Mask8 operator|(Mask8 a, Mask8 b) {
    return {a.bits | b.bits};
}
VYBEG_INLINED inline Mask8 operator!(Mask8 a) {
    return {~a.bits};
}

VYBEG_INLINED inline bool any(bool mask) {
    return mask;
}
VYBEG_INLINED inline bool any(Mask8 mask) {
    const Words8 m = mask.bits;
    return (((m[0] | m[4]) | (m[2] | m[6])) | ((m[1] | m[5]) | (m[3] | m[7]))) != 0;
}

VYBEG_INLINED inline double select(bool where, double yes, double no) {
    return where ? yes : no;
}
VYBEG_INLINED inline Vec8 select(Mask8 where, Vec8 yes, Vec8 no) {
    return (Vec8)(((Words8)yes & where.bits) | ((Words8)no & ~where.bits));
}

VYBEG_INLINED inline double absolute(double x) {
    return std::abs(x);
}
VYBEG_INLINED inline Vec8 absolute(Vec8 x) {
    constexpr unsigned long long all_but_sign = ~0ULL >> 1;
    return (Vec8)((Words8)x & all_but_sign);
}

// Sum of the lanes.
VYBEG_INLINED inline double total(Vec8 x) {
    return ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]));
}

// Rows become columns.
VYBEG_INLINED inline void transpose(std::array<Vec8, lane_count>& m) {
    std::array<Vec8, lane_count> pairs;
    for (std::size_t i = 0; i < lane_count; i += 2) {
        pairs[i] = __builtin_shufflevector(m[i], m[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        pairs[i + 1] = __builtin_shufflevector(m[i], m[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    std::array<Vec8, lane_count> fours;
    for (std::size_t i = 0; i < lane_count; i += 4) {
        for (std::size_t j = i; j < i + 2; ++j) {
            fours[j] = __builtin_shufflevector(pairs[j], pairs[j + 2], 0, 1, 8, 9, 4, 5, 12, 13);
            fours[j + 2] =
                __builtin_shufflevector(pairs[j], pairs[j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
        }
    }
    for (std::size_t j = 0; j < 4; ++j) {
        m[j] = __builtin_shufflevector(fours[j], fours[j + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        m[j + 4] = __builtin_shufflevector(fours[j], fours[j + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
}

// glibc has these for whole vectors (libmvec, to four units of the last place), but declares them
// only under -ffast-math. Separate names keep other code on the scalar functions.
#ifdef __clang__
#define VYBEG_VECTOR_FUNCTION
#else
#define VYBEG_VECTOR_FUNCTION __attribute__((simd("notinbranch"), const))
#endif
extern "C" {
VYBEG_VECTOR_FUNCTION double vybeg_atan2(double y, double x) noexcept __asm__("atan2");
VYBEG_VECTOR_FUNCTION double vybeg_sin(double x) noexcept __asm__("sin");
}

VYBEG_INLINED inline double sqrt_of(double x) {
    return std::sqrt(x);
}
VYBEG_INLINED inline Vec8 sqrt_of(Vec8 x) {
    Vec8 root;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        root[lane] = std::sqrt(x[lane]);
    }
    return root;
}

VYBEG_INLINED inline double atan2_of(double y, double x) {
    return std::atan2(y, x);
}
VYBEG_INLINED inline Vec8 atan2_of(Vec8 y, Vec8 x) {
    Lanes ys;
    Lanes xs;
    store(y, ys);
    store(x, xs);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        ys[lane] = vybeg_atan2(ys[lane], xs[lane]);
    }
    return load(ys);
}

}  // namespace vybeg
