#pragma once

#include "core/base/dispatch.h"

#include <array>
#include <cmath>
#include <cstddef>

// Windows that are worked on side by side in the processor's vectors. Eight is for sources only:
// functions of it must be inlined, and what calls them be VYBEG_DISPATCHED.

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

using EightWords = unsigned long long __attribute__((vector_size(64)));

// where < 0 ? yes : no in each lane, by the sign's bit: GCC takes comparisons of such long vectors
// apart, lane by lane.
VYBEG_INLINED inline Eight if_negative(Eight where, Eight yes, Eight no) {
    const EightWords mask = -((EightWords)where >> 63);
    return (Eight)(((EightWords)yes & mask) | ((EightWords)no & ~mask));
}

// |x|; a NaN gets the sign of a positive number.
VYBEG_INLINED inline Eight absolute(Eight x) {
    constexpr unsigned long long all_but_sign = ~0ULL >> 1;
    return (Eight)((EightWords)x & all_but_sign);
}

// Sum of the lanes.
VYBEG_INLINED inline double total(Eight x) {
    return ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]));
}

// Rows become columns.
VYBEG_INLINED inline void transpose(std::array<Eight, series_lanes>& m) {
    std::array<Eight, series_lanes> pairs;
    for (std::size_t i = 0; i < series_lanes; i += 2) {
        pairs[i] = __builtin_shufflevector(m[i], m[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        pairs[i + 1] = __builtin_shufflevector(m[i], m[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    std::array<Eight, series_lanes> fours;
    for (std::size_t i = 0; i < series_lanes; i += 4) {
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

VYBEG_INLINED inline Eight sqrt_of(Eight x) {
    Eight root;
    for (std::size_t lane = 0; lane < series_lanes; ++lane) {
        root[lane] = std::sqrt(x[lane]);
    }
    return root;
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

VYBEG_INLINED inline Bent operator+(const Bent& a, const Bent& b) {
    return {a.value + b.value, a.slope + b.slope, a.bend + b.bend};
}

VYBEG_INLINED inline Bent operator-(const Bent& a, const Bent& b) {
    return {a.value - b.value, a.slope - b.slope, a.bend - b.bend};
}

VYBEG_INLINED inline Bent operator*(Eight factor, const Bent& a) {
    return {factor * a.value, factor * a.slope, factor * a.bend};
}

VYBEG_INLINED inline Bent operator*(const Bent& a, const Bent& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope,
            a.bend * b.value + 2 * (a.slope * b.slope) + a.value * b.bend};
}

VYBEG_INLINED inline Bent square(const Bent& a) {
    return {a.value * a.value, 2 * (a.value * a.slope), 2 * (a.slope * a.slope + a.value * a.bend)};
}

VYBEG_INLINED inline Bent reciprocal(const Bent& a) {
    const Eight value = 1 / a.value;
    const Eight slope = -a.slope * value * value;
    return {value, slope, -value * (2 * (a.slope * slope) + a.bend * value)};
}

VYBEG_INLINED inline Bent square_root(const Bent& a) {
    const Eight value = sqrt_of(a.value);
    const Eight half = 0.5 / value;
    const Eight slope = a.slope * half;
    return {value, slope, (a.bend - 2 * (slope * slope)) * half};
}

#pragma GCC diagnostic pop

}  // namespace vybeg
