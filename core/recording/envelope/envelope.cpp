#include "core/recording/envelope/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t fan = 16;  // buckets in a bucket of the next level
constexpr float infinite = std::numeric_limits<float>::infinity();

// The range of finite samples, minimum above maximum where there is none; `missing` becomes true
// where any are not finite.
ChannelRange range_of(std::span<const double> samples, bool& missing) {
    double min = std::numeric_limits<double>::infinity();
    double max = -min;
    double zero = 0;  // a NaN or infinite sample minus itself is NaN, which the sum keeps
    for (const double value : samples) {
        min = std::min(min, value);
        max = std::max(max, value);
        zero += value - value;
    }
    if (!(zero == 0)) {
        missing = true;
        min = std::numeric_limits<double>::infinity();
        max = -min;
        for (const double value : samples) {
            if (std::isfinite(value)) {
                min = std::min(min, value);
                max = std::max(max, value);
            }
        }
    }
    constexpr double largest = std::numeric_limits<float>::max();
    return min <= max ? ChannelRange{static_cast<float>(std::clamp(min, -largest, largest)),
                                     static_cast<float>(std::clamp(max, -largest, largest))}
                      : empty_bucket.c;
}

void extend(ChannelRange& into, const ChannelRange& other) {
    into.min = std::min(into.min, other.min);
    into.max = std::max(into.max, other.max);
}

EnvelopeBucket merged(std::span<const EnvelopeBucket> buckets) {
    EnvelopeBucket all = empty_bucket;
    for (const EnvelopeBucket& bucket : buckets) {
        merge(all, bucket);
    }
    return all;
}

}  // namespace

const EnvelopeBucket empty_bucket{.c = {infinite, -infinite}, .d = {infinite, -infinite}};

EnvelopeBucket bucket_of(std::span<const double> c, std::span<const double> d) {
    EnvelopeBucket bucket;
    bucket.c = range_of(c, bucket.missing);
    bucket.d = range_of(d, bucket.missing);
    return bucket;
}

void merge(EnvelopeBucket& into, const EnvelopeBucket& other) {
    extend(into.c, other.c);
    extend(into.d, other.d);
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
    constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
    for (int i = 0; i < count; ++i) {
        const std::int64_t from = first + length * i / count;
        const std::int64_t to = std::max(first + length * (i + 1) / count, from + 1);
        EnvelopeBucket& bucket = result.emplace_back(between(from / leaf, (to + leaf - 1) / leaf));
        for (ChannelRange* const range : {&bucket.c, &bucket.d}) {
            if (range->min > range->max) {
                *range = {nothing, nothing};
            }
        }
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

namespace {

constexpr double look_s = 0.3;  // limit of time for slow disks
constexpr std::int64_t least_parts = 64;

// Looks as buckets of equal parts.
std::vector<EnvelopeBucket> in_parts(const std::vector<ScannedPlace>& looks, std::int64_t parts) {
    EnvelopeBucket unseen = empty_bucket;
    unseen.coverage = Coverage::none;
    std::vector<EnvelopeBucket> buckets(static_cast<std::size_t>(parts), unseen);
    for (const ScannedPlace& look : looks) {
        // Places follow from times of a file and may have any value.
        if (look.place >= 0 && look.place <= 1) {
            const auto at = static_cast<std::int64_t>(look.place * static_cast<double>(parts));
            EnvelopeBucket& bucket = buckets[static_cast<std::size_t>(std::min(at, parts - 1))];
            merge(bucket, look.seen);
            bucket.coverage = Coverage::some;
        }
    }
    return buckets;
}

}  // namespace

Result<std::vector<EnvelopeBucket>> sparse_scan(
    std::int64_t most, const JobControl& job,
    const std::function<Result<ScannedPlace>(std::int64_t part, std::int64_t parts)>& look) {
    const double until = job.now() + look_s;
    std::vector<ScannedPlace> looks;
    std::int64_t complete = 0;
    for (std::int64_t parts = least_parts; parts <= most; parts *= 2) {
        // Even parts were read with half as many parts.
        const std::int64_t step = parts > least_parts ? 2 : 1;
        for (std::int64_t part = step - 1; part < parts; part += step) {
            TRY(job.go_on());
            if (job.now() > until) {
                return complete > 0 ? in_parts(looks, complete) : std::vector<EnvelopeBucket>{};
            }
            auto seen = TRY(look(part, parts));
            looks.push_back(std::move(seen));
        }
        complete = parts;
    }
    return in_parts(looks, complete);
}

namespace {

using Samples = std::vector<EnvelopeBucket>;

constexpr double picture_interval_s = 0.1;
constexpr std::int64_t most_looks = 2048;  // about the pixels of a window's width
// A look contains the crests of any carrier above 1/256 of the sample rate; all looks together are
// at most a sixteenth of the recording.
constexpr std::int64_t frames_per_look = 256;
constexpr std::int64_t frames_per_part = 16 * frames_per_look;

std::int64_t block_count(std::int64_t frames) {
    return (frames + EnvelopeBlock::frames - 1) / EnvelopeBlock::frames;
}

}  // namespace

Result<std::shared_ptr<const Envelope>> build_envelope(const SampleSource& source,
                                                       const JobControl& job,
                                                       const EnvelopeSink& sink) {
    const std::int64_t frames = source.frames();
    std::vector<std::shared_ptr<const EnvelopeBlock>> blocks(
        static_cast<std::size_t>(block_count(frames)));
    std::shared_ptr<const Samples> samples;
    double published = job.now();
    std::vector<double> c;
    std::vector<double> d;
    const auto read_frames = [&](std::int64_t first, std::int64_t length) -> Status {
        TRY(job.go_on());
        c.resize(static_cast<std::size_t>(length));
        d.resize(c.size());
        return source.read(first, c, d);
    };
    const auto picture = [&] { return std::make_shared<const Envelope>(frames, blocks, samples); };
    const auto publish = [&] {
        sink(picture());
        published = job.now();
    };
    const auto look = [&](std::int64_t part, std::int64_t parts) -> Result<ScannedPlace> {
        TRY(read_frames(frames * part / parts, frames_per_look));
        return ScannedPlace{static_cast<double>(part) / static_cast<double>(parts),
                            bucket_of(c, d)};
    };
    if (sink && source.seeks()) {
        auto seen = TRY(sparse_scan(std::min(most_looks, frames / frames_per_part), job, look));
        if (!seen.empty()) {
            samples = std::make_shared<const Samples>(std::move(seen));
            publish();
        }
    }
    for (std::size_t index = 0; index < blocks.size(); ++index) {
        const std::int64_t at = static_cast<std::int64_t>(index) * EnvelopeBlock::frames;
        const std::int64_t length = std::min(EnvelopeBlock::frames, frames - at);
        TRY(read_frames(at, length));
        blocks[index] = std::make_shared<const EnvelopeBlock>(c, d);
        if (sink && index + 1 < blocks.size() && job.now() - published >= picture_interval_s) {
            publish();
        }
        job.report(static_cast<double>(at + length) / static_cast<double>(frames));
    }
    return picture();
}

std::shared_ptr<const Envelope> sampled_envelope(std::int64_t frames, Samples samples) {
    std::vector<std::shared_ptr<const EnvelopeBlock>> blocks(
        static_cast<std::size_t>(block_count(frames)));
    return std::make_shared<const Envelope>(frames, std::move(blocks),
                                            std::make_shared<const Samples>(std::move(samples)));
}

}  // namespace vybeg
