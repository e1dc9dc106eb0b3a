#include "core/recording/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace vybeg {
namespace {

constexpr std::int64_t leaf = 16;            // frames in a bucket of the finest level
constexpr std::int64_t fan = 16;             // buckets in a bucket of the next level
constexpr std::int64_t chunk = leaf * 4096;  // frames read at a time: both channels stay in cache

// Inside of the pyramid a bucket without samples has its minimum above its maximum, so that plain
// comparisons merge it; it becomes NaN on the way out.
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr EnvelopeBucket empty{infinite, -infinite, infinite, -infinite, false};

struct Extent {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    bool missing = false;
};

Extent extent_of(std::span<const double> samples) {
    Extent extent;
    double zero = 0;  // a NaN or infinite sample minus itself is NaN, which stays in the sum
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

EnvelopeBucket bucket_of(std::span<const double> c, std::span<const double> d) {
    const Extent in_c = extent_of(c);
    const Extent in_d = extent_of(d);
    EnvelopeBucket bucket = empty;
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

EnvelopeBucket merged(std::span<const EnvelopeBucket> buckets) {
    EnvelopeBucket all = empty;
    for (const EnvelopeBucket& bucket : buckets) {
        merge(all, bucket);
    }
    return all;
}

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

Result<std::shared_ptr<const Envelope>> Envelope::build(const SampleSource& source,
                                                        const JobControl& job) {
    auto envelope = std::make_shared<Envelope>();
    envelope->frames_ = source.frames();
    std::vector<EnvelopeBucket> finest;
    finest.reserve(static_cast<std::size_t>((source.frames() + leaf - 1) / leaf));
    std::vector<double> c;
    std::vector<double> d;
    for (std::int64_t at = 0; at < source.frames(); at += chunk) {
        if (job.cancelled()) {
            return Error{.code = ErrorCode::interrupted, .where = "", .args = {}};
        }
        const std::int64_t length = std::min(chunk, source.frames() - at);
        c.resize(static_cast<std::size_t>(length));
        d.resize(c.size());
        if (Status status = source.read(at, c, d); !status) {
            return status.error();
        }
        for (std::size_t i = 0; i < c.size(); i += leaf) {
            const std::size_t count = std::min<std::size_t>(leaf, c.size() - i);
            finest.push_back(
                bucket_of(std::span(c).subspan(i, count), std::span(d).subspan(i, count)));
        }
        job.report(static_cast<double>(at + length) / static_cast<double>(source.frames()));
    }

    envelope->levels_.push_back(std::move(finest));
    while (envelope->levels_.back().size() > 1) {
        const std::span<const EnvelopeBucket> fine = envelope->levels_.back();
        std::vector<EnvelopeBucket> coarse;
        coarse.reserve(fine.size() / fan + 1);
        for (std::size_t i = 0; i < fine.size(); i += fan) {
            coarse.push_back(merged(fine.subspan(i, std::min<std::size_t>(fan, fine.size() - i))));
        }
        envelope->levels_.push_back(std::move(coarse));
    }
    return std::shared_ptr<const Envelope>(std::move(envelope));
}

std::vector<EnvelopeBucket> Envelope::buckets(std::int64_t first, std::int64_t end,
                                              int count) const {
    std::vector<EnvelopeBucket> result;
    result.reserve(static_cast<std::size_t>(count));
    const std::int64_t length = end - first;
    for (int i = 0; i < count; ++i) {
        const std::int64_t from = first + length * i / count;
        const std::int64_t to = std::max(first + length * (i + 1) / count, from + 1);
        result.push_back(marked(between(from / leaf, (to + leaf - 1) / leaf)));
    }
    return result;
}

EnvelopeBucket Envelope::between(std::int64_t from, std::int64_t to) const {
    EnvelopeBucket all = empty;
    // Buckets that do not fill one of the next level are taken on the level at hand, at most 15 at
    // either end; the rest is left to the coarser levels.
    for (const std::vector<EnvelopeBucket>& level : levels_) {
        for (; from < to && from % fan != 0; ++from) {
            merge(all, level[from]);
        }
        for (; from < to && to % fan != 0; --to) {
            merge(all, level[to - 1]);
        }
        from /= fan;
        to /= fan;
    }
    return all;
}

}  // namespace vybeg
