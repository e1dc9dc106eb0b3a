#include "core/recording/samples/recent_blocks.h"

#include <algorithm>
#include <utility>

namespace vybeg {

void SampleBlock::copy_to(std::int64_t at, std::span<double> out_c, std::span<double> out_d) const {
    const std::int64_t from = std::max(first, at);
    const std::int64_t end = std::min(first + std::ssize(c), at + std::ssize(out_c));
    if (from < end) {
        std::copy_n(c.begin() + (from - first), end - from, out_c.begin() + (from - at));
        std::copy_n(d.begin() + (from - first), end - from, out_d.begin() + (from - at));
    }
}

SampleBlockPointer RecentBlocks::find(std::int64_t index) const {
    const auto blocks = blocks_.hold();
    const auto found =
        std::ranges::find_if(*blocks, [&](const auto& block) { return block->index == index; });
    if (found == blocks->end()) {
        return nullptr;
    }
    std::rotate(blocks->begin(), found, found + 1);
    return blocks->front();
}

void RecentBlocks::keep(SampleBlockPointer block) const {
    const auto blocks = blocks_.hold();
    blocks->insert(blocks->begin(), std::move(block));
    blocks->resize(std::min(blocks->size(), most_));
}

}  // namespace vybeg
