#pragma once

#include "core/estimators/batch/taylor_window.h"
#include "core/estimators/wave/estimator.h"
#include "core/numerics/lanes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vybeg {

// Kernels of projection_sums.h: sums over samples, and sums moved to another centre.

// e^{iw distance} as a series in x: moves a series from its centre of time to another one, which
// lies `distance` samples before it.
struct CentreShift {
    double turn_cos = 0;  // of w0 distance
    double turn_sin = 0;
    std::array<double, taylor_orders> powers{};  // (2 distance/n)^k/k!
    // Real and imaginary part together, after as many zeros.
    std::array<double, 2 * taylor_orders> re{};
    std::array<double, 2 * taylor_orders> im{};
};
CentreShift centre_shift(const TaylorBasis& basis, double distance);

// Consecutive samples of a window or a hop from `first` on, in segments of the basis.
struct SampleCut {
    std::int64_t first = 0;
    std::int64_t length = 0;
    // Of each segment; empty where the first segment holds all samples.
    std::vector<CentreShift> shifts;
};

// Samples of both channels in memory.
struct SampleColumns {
    const double* c = nullptr;
    const double* d = nullptr;
    const double* delayed = nullptr;  // d delayed by a quarter period; or null

    SampleColumns from(std::int64_t j) const {
        return {c + j, d + j, delayed == nullptr ? nullptr : delayed + j};
    }
};

// The sums of `count` cuts of equal length that begin `hop` samples apart, side by side; the lanes
// beyond repeat the last one.
void sum_cuts(SampleColumns samples, std::int64_t hop, std::size_t count, const SampleCut& cut,
              const TaylorBasis& basis, ProjectionBatch& batch);

// Numbers of a batch: the series' coefficients, then the products.
inline constexpr std::size_t batch_coefficients = 4 * taylor_orders;
inline constexpr std::size_t batch_numbers = batch_coefficients + 4;

// Calls number(kind, lanes) for all numbers of a batch.
template <class Batch, class Number>
void for_numbers(Batch& batch, Number number) {
    for (std::size_t k = 0; k < taylor_orders; ++k) {
        number(k, batch.c_cos[k]);
        number(taylor_orders + k, batch.c_sin[k]);
        number(2 * taylor_orders + k, batch.d_cos[k]);
        number(3 * taylor_orders + k, batch.d_sin[k]);
    }
    number(batch_coefficients, batch.cc);
    number(batch_coefficients + 1, batch.dd);
    number(batch_coefficients + 2, batch.cd);
    number(batch_coefficients + 3, batch.cq);
}

// Sums over many hops or groups of hops; numbers of one kind are contiguous.
struct HopSums {
    std::vector<double> numbers;
    std::size_t pitch = 0;  // from kind to kind; whole lanes may be read and written
    void reset(std::size_t runs);
};

// Adds the sums first .. first + count - 1 of `from`, moved to another centre, to the first ones of
// `to`, which may be the same table.
void add_shifted_runs(HopSums& to, const HopSums& from, std::size_t first, std::size_t count,
                      const CentreShift& shift);

// Move of hop sums, each with its own distance, to one centre and another reference frequency.
struct HopMove {
    double n = 0;         // samples of a window
    double w = 0;         // new reference frequency, rad per sample
    double x = 0;         // new reference frequency less the old one, times n/2
    double distance = 0;  // from the new centre to that of the first hop sum, samples
    double step = 0;      // increase of the distance per hop sum, samples
};

// Moves the sums first .. first + count - 1 of `from` into the first ones of `to`. Each is moved
// separately, so that a missing sample affects its own sum only. Relative error at the distance x
// from the reference: (x v)^8/8!, v the largest distance of a sample from the centre of its sum, in
// half windows.
void move_hops(HopSums& to, const HopSums& from, std::size_t first, std::size_t count,
               const HopMove& move);

// Sums of windows 0 .. count - 1. Window k consists of the terms k .. k + whole - 1, all of one
// centre, and of heads[k]. The part common to all windows is summed once, the part on its left from
// right to left, the part on its right from left to right. Precondition: count <= whole.
void sum_windows(HopSums& windows, const HopSums& terms, const HopSums& heads, bool has_heads,
                 std::size_t whole, std::size_t count);

}  // namespace vybeg
