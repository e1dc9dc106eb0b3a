#pragma once

#include "core/estimators/batch/projection_kernels.h"
#include "core/estimators/batch/taylor_window.h"
#include "core/estimators/wave/estimator.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace vybeg {

// The sums of a block's windows as power series, each sample being touched once.
//
// Windows that stand apart are projected one after the other. Where long ones overlap by half or
// more, the samples between two window starts, a hop, are projected once, and windows are put
// together of hops: runs of 1, 2, 4, ... hops are made by bringing the series of two runs to one
// centre, all runs of a length side by side. A window then takes about 2 log2(length/hop) such
// steps. Its sums are of its own samples alone, added in the same order wherever the block begins.
class ProjectionSums {
public:
    // What a block's sums take much room for; several that take up blocks in turn may share it.
    struct Tables {
        HopSums runs;
        HopSums heads;
        HopSums windows;
        // Of move().
        HopSums terms;
        HopSums ends;
        HopSums sums;
    };

    // Keeps a reference to the basis.
    explicit ProjectionSums(const TaylorBasis& basis,
                            std::shared_ptr<Tables> tables = std::make_shared<Tables>())
        : basis_(basis), tables_(std::move(tables)) {}

    // Takes up the first `count` windows of a block, whose samples must stay until the last
    // batch(). `delayed` are the block's d by a quarter period later, as many as d; empty where
    // nobody asks for cq. Precondition: the windows are as long as those of the basis.
    void take(const WindowBlock& block, std::size_t count, std::span<const double> delayed = {});

    // The sums of `count` windows of that block from window `first` on, count <= lane_count; the
    // lanes beyond repeat the last one.
    void batch(std::size_t first, std::size_t count, ProjectionBatch& batch);

    // Whether the windows are put together of hops; then they can be for another frequency, too:
    // windows first .. first + count - 1 of the block, at the frame's, which lies near the basis'.
    // Those of batch() are then these ones. Precondition: count <= most_moved(), and as far as the
    // block goes.
    bool overlapping() const { return overlapping_; }
    std::size_t most_moved() const { return static_cast<std::size_t>(basis_.length() / hop_); }
    void move(std::size_t first, std::size_t count, const TaylorFrame& frame);

private:
    void prepare(std::int64_t hop);
    SampleCut cut(std::int64_t first, std::int64_t length, double distance) const;
    void project_hops(std::size_t count);
    void join_hops(std::size_t count);

    const TaylorBasis& basis_;
    std::int64_t hop_ = 0;  // for which the cuts are made
    bool overlapping_ = false;
    SampleCut whole_;  // a window that stands apart
    SampleCut head_;   // of a hop, as far as a window reaches into its last one
    SampleCut rest_;   // of a hop
    WindowBlock block_;
    std::span<const double> delayed_;
    std::shared_ptr<Tables> tables_;
    std::size_t count_ = 0;       // windows of the block
    std::size_t in_windows_ = 0;  // the first window of windows_
    enum class Runs { none, of_one_hop, joined } state_ = Runs::none;
    double origin_ = 0;  // of a hop's series, from its first sample
};

}  // namespace vybeg
