#pragma once

#include "core/estimators/estimator.h"
#include "core/estimators/window_series.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vybeg {

// e^{iw distance} as a series in x: brings a series that counts time from one centre to another,
// which lies `distance` samples before it.
struct SeriesShift {
    double turn_cos = 0;  // of w0 distance
    double turn_sin = 0;
    std::array<double, series_orders> powers{};  // (2 distance/n)^k/k!
    // Both together, real and imaginary part, behind as many zeros.
    std::array<double, 2 * series_orders> re{};
    std::array<double, 2 * series_orders> im{};
};
SeriesShift series_shift(const SeriesBasis& basis, double distance);

// Samples that follow each other, from `first` on of a window or a hop, in stretches of the basis.
struct SeriesCut {
    std::int64_t first = 0;
    std::int64_t length = 0;
    std::vector<SeriesShift> shifts;  // of each stretch; none where the first one holds them all
};

// The sums of a block's windows as power series, each sample being touched once.
//
// Windows that stand apart are projected one after the other. Where long ones overlap by half or
// more, the samples between two window starts, a hop, are projected once, and windows are put
// together of hops: runs of 1, 2, 4, ... hops are made by bringing the series of two runs to one
// centre, all runs of a length side by side. A window then takes about 2 log2(length/hop) such
// steps. Its sums are of its own samples alone, added in the same order wherever the block begins.
class SeriesSums {
public:
    // Keeps a reference to the basis.
    explicit SeriesSums(const SeriesBasis& basis) : basis_(basis) {}

    // Takes up the first `count` windows of a block, whose samples must stay until the last
    // batch(). `delayed` are the block's d by a quarter period later, as many as d; empty where
    // nobody asks for cq. Precondition: the windows are as long as those of the basis.
    void take(const WindowBlock& block, std::size_t count, std::span<const double> delayed = {});

    // The sums of `count` windows of that block from window `first` on, count <= series_lanes; the
    // lanes beyond repeat the last one.
    void batch(std::size_t first, std::size_t count, SeriesBatch& batch) const;

private:
    // Numbers of many runs: those of one kind, such as all c_cos of order 0, follow each other.
    struct Table {
        std::vector<double> numbers;
        std::size_t pitch = 0;
        void reset(std::size_t runs);
    };

    void prepare(std::int64_t hop);
    SeriesCut cut(std::int64_t first, std::int64_t length, double distance) const;
    void project_hops(std::size_t count);
    void join_hops(std::size_t count);

    const SeriesBasis& basis_;
    std::int64_t hop_ = 0;  // for which the cuts are made
    bool overlapping_ = false;
    SeriesCut whole_;  // a window that stands apart
    SeriesCut head_;   // of a hop, as far as a window reaches into its last one
    SeriesCut rest_;   // of a hop
    WindowBlock block_;
    std::span<const double> delayed_;
    Table runs_;
    Table heads_;
    Table windows_;
};

}  // namespace vybeg
