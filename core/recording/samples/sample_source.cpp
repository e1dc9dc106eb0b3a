#include "core/recording/samples/sample_source.h"

#include "core/numerics/fractional_delay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace vybeg {

Status MemorySource::read(std::int64_t first, std::span<double> c, std::span<double> d) const {
    std::copy_n(c_.begin() + first, c.size(), c.begin());
    std::copy_n(d_.begin() + first, d.size(), d.begin());
    return {};
}

namespace {

constexpr double missing_sample = std::numeric_limits<double>::quiet_NaN();

class MappedSource final : public SampleSource {
public:
    MappedSource(std::shared_ptr<const SampleSource> source,
                 std::function<void(std::span<double> c, std::span<double> d)> change)
        : source_(std::move(source)), change_(std::move(change)) {}

    std::int64_t frames() const override { return source_->frames(); }
    bool seeks() const override { return source_->seeks(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        TRY(source_->read(first, c, d));
        change_(c, d);
        return {};
    }

private:
    std::shared_ptr<const SampleSource> source_;
    std::function<void(std::span<double> c, std::span<double> d)> change_;
};

class JoinedSource final : public SampleSource {
public:
    explicit JoinedSource(std::vector<SourcePiece> pieces) : pieces_(std::move(pieces)) {}

    std::int64_t frames() const override { return pieces_.back().end(); }
    bool seeks() const override {
        return std::ranges::all_of(pieces_, [](const SourcePiece& p) { return p.source->seeks(); });
    }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        std::ranges::fill(c, missing_sample);
        std::ranges::fill(d, missing_sample);
        const std::int64_t end = first + std::ssize(c);
        auto piece = std::ranges::upper_bound(pieces_, first, {}, &SourcePiece::end);
        for (; piece != pieces_.end() && piece->first < end; ++piece) {
            const std::int64_t begin = std::max(first, piece->first);
            const std::int64_t count = std::min(end, piece->end()) - begin;
            if (count > 0) {
                const auto part = [&](std::span<double> all) {
                    return all.subspan(static_cast<std::size_t>(begin - first),
                                       static_cast<std::size_t>(count));
                };
                TRY(piece->source->read(piece->from + begin - piece->first, part(c), part(d)));
            }
        }
        return {};
    }

private:
    std::vector<SourcePiece> pieces_;
};

class DelayedSource final : public SampleSource {
public:
    DelayedSource(std::shared_ptr<const SampleSource> source, double delay_samples)
        : source_(std::move(source)), delay_(delay_samples) {}

    std::int64_t frames() const override { return source_->frames(); }
    bool seeks() const override { return source_->seeks(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        const std::int64_t before = delay_.reach_before();
        const std::int64_t after = delay_.reach_after();
        std::ranges::fill(c, missing_sample);
        std::ranges::fill(d, missing_sample);
        const std::int64_t begin = std::max(first, before);
        const std::int64_t end = std::min(first + std::ssize(c), frames() - after);
        // Blocks bound the memory of a long read, and are never short beside what is read twice.
        const std::int64_t block = std::max<std::int64_t>(1 << 16, before + after);
        std::vector<double> raw_c;
        std::vector<double> raw_d;
        for (std::int64_t at = begin; at < end; at += block) {
            const std::int64_t length = std::min(block, end - at);
            raw_c.resize(static_cast<std::size_t>(before + length + after));
            raw_d.resize(raw_c.size());
            TRY(source_->read(at - before, raw_c, raw_d));
            std::copy_n(raw_c.begin() + before, length, c.begin() + (at - first));
            delay_.apply(
                raw_d, before,
                d.subspan(static_cast<std::size_t>(at - first), static_cast<std::size_t>(length)));
        }
        return {};
    }

private:
    std::shared_ptr<const SampleSource> source_;
    FractionalDelay delay_;
};

}  // namespace

std::shared_ptr<const SampleSource> mapped_source(
    std::shared_ptr<const SampleSource> source,
    std::function<void(std::span<double> c, std::span<double> d)> change) {
    return std::make_shared<MappedSource>(std::move(source), std::move(change));
}

std::shared_ptr<const SampleSource> joined_source(std::vector<SourcePiece> pieces) {
    return std::make_shared<JoinedSource>(std::move(pieces));
}

void scale_samples(std::span<double> values, double scale) {
    for (double& value : values) {
        value *= scale;
        value = std::isfinite(value) ? value : missing_sample;
    }
}

std::shared_ptr<const SampleSource> scaled_source(std::shared_ptr<const SampleSource> source,
                                                  double scale_c, double scale_d) {
    return mapped_source(std::move(source), [=](std::span<double> c, std::span<double> d) {
        scale_samples(c, scale_c);
        scale_samples(d, scale_d);
    });
}

std::shared_ptr<const SampleSource> delayed_source(std::shared_ptr<const SampleSource> source,
                                                   double delay_samples) {
    // A shift by the whole recording leaves as little of it as any larger one.
    const auto frames = static_cast<double>(source->frames());
    const double delay = std::clamp(delay_samples, -frames, frames);
    return std::make_shared<DelayedSource>(std::move(source), delay);
}

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
