#include "core/recording/envelope/envelope.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

EnvelopeBucket marked(EnvelopeBucket bucket) {
    constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
    if (bucket.c_min > bucket.c_max) {
        bucket.c_min = bucket.c_max = nothing;
    }
    if (bucket.d_min > bucket.d_max) {
        bucket.d_min = bucket.d_max = nothing;
    }
    return bucket;
}

}  // namespace

Envelope::Envelope(std::int64_t frames, std::vector<std::shared_ptr<const EnvelopeBlock>> blocks,
                   std::shared_ptr<const std::vector<EnvelopeBucket>> samples)
    : frames_(frames),
      whole_(std::ranges::all_of(blocks, [](const auto& block) { return block != nullptr; })),
      blocks_(std::move(blocks)),
      samples_(std::move(samples)) {}

std::vector<EnvelopeBucket> Envelope::buckets(std::int64_t first, std::int64_t end,
                                              int count) const {
    std::vector<EnvelopeBucket> result;
    result.reserve(static_cast<std::size_t>(count));
    const std::int64_t length = end - first;
    constexpr std::int64_t leaf = EnvelopeBlock::leaf;
    for (int i = 0; i < count; ++i) {
        const std::int64_t from = first + length * i / count;
        const std::int64_t to = std::max(first + length * (i + 1) / count, from + 1);
        result.push_back(marked(between(from / leaf, (to + leaf - 1) / leaf)));
    }
    return result;
}

EnvelopeBucket Envelope::between(std::int64_t from, std::int64_t to) const {
    constexpr std::int64_t leaves = EnvelopeBlock::leaves;
    EnvelopeBucket all = empty_bucket;
    bool all_read = true;
    bool anything = false;
    while (from < to) {
        const std::int64_t index = from / leaves;
        const std::int64_t begin = index * leaves;
        const std::int64_t end = std::min(begin + leaves, to);
        if (const auto& block = blocks_[static_cast<std::size_t>(index)]) {
            block->merge_leaves(from - begin, end - begin, all);
            anything = true;
        } else {
            all_read = false;
            anything = merge_samples(from, end, all) || anything;
        }
        from = end;
    }
    all.coverage = all_read ? Coverage::all : anything ? Coverage::some : Coverage::none;
    return all;
}

bool Envelope::merge_samples(std::int64_t from, std::int64_t to, EnvelopeBucket& into) const {
    if (!samples_ || samples_->empty()) {
        return false;
    }
    const std::int64_t parts = std::ssize(*samples_);
    const auto part_at = [&](std::int64_t frame) {
        return std::min(frame * parts / frames_, parts - 1);
    };
    const std::int64_t last = part_at(std::min(to * EnvelopeBlock::leaf, frames_) - 1);
    bool anything = false;
    for (std::int64_t part = part_at(from * EnvelopeBlock::leaf); part <= last; ++part) {
        const EnvelopeBucket& bucket = (*samples_)[static_cast<std::size_t>(part)];
        if (bucket.coverage != Coverage::none) {
            merge(into, bucket);
            anything = true;
        }
    }
    return anything;
}

}  // namespace vybeg
