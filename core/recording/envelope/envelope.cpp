#include "core/recording/envelope/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t fan = 16;  // buckets in a bucket of the next level
constexpr float infinite = std::numeric_limits<float>::infinity();

struct Extent {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    bool missing = false;
};

Extent extent_of(std::span<const double> samples) {
    Extent extent;
    double zero = 0;  // a NaN or infinite sample minus itself is NaN, which the sum keeps
    for (const double value : samples) {
        extent.min = std::min(extent.min, value);
        extent.max = std::max(extent.max, value);
        zero += value - value;
    }
    if (zero == 0) {
        return extent;
    }
    extent = {.missing = true};
    for (const double value : samples) {
        if (std::isfinite(value)) {
            extent.min = std::min(extent.min, value);
            extent.max = std::max(extent.max, value);
        }
    }
    return extent;
}

float to_float(double value) {
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -largest, largest));
}

EnvelopeBucket merged(std::span<const EnvelopeBucket> buckets) {
    EnvelopeBucket all = empty_bucket;
    for (const EnvelopeBucket& bucket : buckets) {
        merge(all, bucket);
    }
    return all;
}

}  // namespace

const EnvelopeBucket empty_bucket{
    .c_min = infinite, .c_max = -infinite, .d_min = infinite, .d_max = -infinite};

EnvelopeBucket bucket_of(std::span<const double> c, std::span<const double> d) {
    const Extent in_c = extent_of(c);
    const Extent in_d = extent_of(d);
    EnvelopeBucket bucket = empty_bucket;
    if (in_c.min <= in_c.max) {
        bucket.c_min = to_float(in_c.min);
        bucket.c_max = to_float(in_c.max);
    }
    if (in_d.min <= in_d.max) {
        bucket.d_min = to_float(in_d.min);
        bucket.d_max = to_float(in_d.max);
    }
    bucket.missing = in_c.missing || in_d.missing;
    return bucket;
}

void merge(EnvelopeBucket& into, const EnvelopeBucket& other) {
    into.c_min = std::min(into.c_min, other.c_min);
    into.c_max = std::max(into.c_max, other.c_max);
    into.d_min = std::min(into.d_min, other.d_min);
    into.d_max = std::max(into.d_max, other.d_max);
    into.missing = into.missing || other.missing;
}

EnvelopeBlock::EnvelopeBlock(std::span<const double> c, std::span<const double> d) {
    std::vector<EnvelopeBucket> finest;
    finest.reserve(c.size() / leaf + 1);
    for (std::size_t i = 0; i < c.size(); i += leaf) {
        const std::size_t count = std::min<std::size_t>(leaf, c.size() - i);
        finest.push_back(bucket_of(c.subspan(i, count), d.subspan(i, count)));
    }
    levels_.push_back(std::move(finest));
    while (levels_.back().size() > 1) {
        const std::span<const EnvelopeBucket> fine = levels_.back();
        std::vector<EnvelopeBucket> coarse;
        coarse.reserve(fine.size() / fan + 1);
        for (std::size_t i = 0; i < fine.size(); i += fan) {
            coarse.push_back(merged(fine.subspan(i, std::min<std::size_t>(fan, fine.size() - i))));
        }
        levels_.push_back(std::move(coarse));
    }
}

void EnvelopeBlock::merge_leaves(std::int64_t from, std::int64_t to, EnvelopeBucket& into) const {
    // Buckets that do not fill one of the next level are merged on this level, at most 15 at either
    // end; the coarser levels cover the rest.
    for (const std::vector<EnvelopeBucket>& level : levels_) {
        for (; from < to && from % fan != 0; ++from) {
            merge(into, level[static_cast<std::size_t>(from)]);
        }
        for (; from < to && to % fan != 0; --to) {
            merge(into, level[static_cast<std::size_t>(to - 1)]);
        }
        from /= fan;
        to /= fan;
    }
}

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
