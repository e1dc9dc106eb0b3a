#pragma once

#include "core/estimators/estimator.h"
#include "core/estimators/series_kernels.h"
#include "core/estimators/window_series.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace vybeg {

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
    RunTable runs_;
    RunTable heads_;
    RunTable windows_;
};

}  // namespace vybeg
