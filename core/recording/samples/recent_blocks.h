#pragma once

#include "core/base/guarded.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vybeg {

// Samples that a source computes in one go.
struct SampleBlock {
    std::int64_t index = 0;  // among the source's blocks
    std::int64_t first = 0;  // frame
    std::vector<double> c;
    std::vector<double> d;

    // Fills of the frames from `at` on those that lie in the block.
    void copy_to(std::int64_t at, std::span<double> out_c, std::span<double> out_d) const;
};

using SampleBlockPointer = std::shared_ptr<const SampleBlock>;

// The blocks used last, for reads that go on inside of one. For several threads at once.
class RecentBlocks {
public:
    explicit RecentBlocks(std::size_t most) : most_(most) {}

    // Null, where it is not kept.
    SampleBlockPointer find(std::int64_t index) const;
    void keep(SampleBlockPointer block) const;

private:
    std::size_t most_;
    Guarded<std::vector<SampleBlockPointer>> blocks_;  // the last one used first
};

}  // namespace vybeg
