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

// Sums of the windows of a block as power series; each sample is used once.
//
// Short windows and windows with little overlap are projected one by one. Where long windows
// overlap by half or more, the samples between two window starts, a hop, are projected once, and a
// window is a sum of hops. Sums over 1, 2, 4, ... hops result from moving two shorter sums to one
// centre; all sums of one length are computed side by side. A window takes about 2 log2(length/hop)
// such steps. Its sums contain its own samples only, added in the same order wherever the block
// begins.
class ProjectionSums {
public:
    // Large tables of a block's sums; several ProjectionSums that process blocks in turn may share
    // them.
    struct Tables {
        HopSums runs;
        HopSums heads;
        HopSums windows;
        // Used by move().
        HopSums terms;
        HopSums ends;
        HopSums sums;
    };

    // Keeps a reference to the basis.
    explicit ProjectionSums(const TaylorBasis& basis,
                            std::shared_ptr<Tables> tables = std::make_shared<Tables>())
        : basis_(basis), tables_(std::move(tables)) {}

    // Begins with the first `count` windows of a block. `delayed` is the block's d delayed by a
    // quarter period, of the length of d; empty where cq is not needed. Preconditions: the windows
    // have the length of the basis; the samples exist until the last batch().
    void take(const WindowBlock& block, std::size_t count, std::span<const double> delayed = {});

    // Computes the sums of `count` windows of that block from window `first` on, count <=
    // lane_count; unused lanes repeat the last window.
    void batch(std::size_t first, std::size_t count, ProjectionBatch& batch);

    // Whether windows are sums of hops. Only then move() computes windows first .. first + count -
    // 1 of the block at the frequency of `frame`, near that of the basis; batch() then returns
    // these. Precondition: count <= most_moved(), within the block.
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
    SampleCut whole_;  // a window projected as a whole
    SampleCut head_;   // start of a hop, up to the end of a window
    SampleCut rest_;   // remainder of a hop
    WindowBlock block_;
    std::span<const double> delayed_;
    std::shared_ptr<Tables> tables_;
    std::size_t count_ = 0;       // windows of the block
    std::size_t in_windows_ = 0;  // the first window of windows_
    enum class Runs { none, of_one_hop, joined } state_ = Runs::none;
    double origin_ = 0;  // centre of a hop's series, from its first sample
};

}  // namespace vybeg
