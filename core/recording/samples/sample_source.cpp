#include "core/recording/samples/sample_source.h"

#include "core/numerics/fractional_delay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vybeg {

Status MemorySource::read(std::int64_t first, std::span<double> c, std::span<double> d) const {
    std::copy_n(c_.begin() + first, c.size(), c.begin());
    std::copy_n(d_.begin() + first, d.size(), d.begin());
    return {};
}

namespace {

constexpr double missing_sample = std::numeric_limits<double>::quiet_NaN();

class ReadSource final : public SampleSource {
public:
    ReadSource(std::int64_t frames, bool seeks, ReadFrames read)
        : frames_(frames), seeks_(seeks), read_(std::move(read)) {}

    std::int64_t frames() const override { return frames_; }
    bool seeks() const override { return seeks_; }
    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        return read_(first, c, d);
    }

private:
    std::int64_t frames_;
    bool seeks_;
    ReadFrames read_;
};

}  // namespace

std::shared_ptr<const SampleSource> source_of(std::int64_t frames, bool seeks, ReadFrames read) {
    return std::make_shared<ReadSource>(frames, seeks, std::move(read));
}

std::shared_ptr<const SampleSource> mapped_source(
    std::shared_ptr<const SampleSource> source,
    std::function<void(std::span<double> c, std::span<double> d)> change) {
    return source_of(source->frames(), source->seeks(),
                     [source, change = std::move(change)](std::int64_t first, std::span<double> c,
                                                          std::span<double> d) -> Status {
                         TRY(source->read(first, c, d));
                         change(c, d);
                         return {};
                     });
}

std::shared_ptr<const SampleSource> joined_source(std::vector<SourcePiece> pieces) {
    const std::int64_t frames = pieces.back().end();
    const bool seeks =
        std::ranges::all_of(pieces, [](const SourcePiece& p) { return p.source->seeks(); });
    const auto read = [pieces = std::move(pieces)](std::int64_t first, std::span<double> c,
                                                   std::span<double> d) -> Status {
        std::ranges::fill(c, missing_sample);
        std::ranges::fill(d, missing_sample);
        const std::int64_t end = first + std::ssize(c);
        auto piece = std::ranges::upper_bound(pieces, first, {}, &SourcePiece::end);
        for (; piece != pieces.end() && piece->first < end; ++piece) {
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
    };
    return source_of(frames, seeks, read);
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
    const std::int64_t frames = source->frames();
    // A shift by the whole recording leaves as little of it as any larger one.
    const auto most = static_cast<double>(frames);
    const FractionalDelay delay(std::clamp(delay_samples, -most, most));
    const auto read = [source, frames, delay](std::int64_t first, std::span<double> c,
                                              std::span<double> d) -> Status {
        const std::int64_t before = delay.reach_before();
        const std::int64_t after = delay.reach_after();
        std::ranges::fill(c, missing_sample);
        std::ranges::fill(d, missing_sample);
        const std::int64_t begin = std::max(first, before);
        const std::int64_t end = std::min(first + std::ssize(c), frames - after);
        // Blocks bound the memory of a long read, and are never short beside what is read twice.
        const std::int64_t block = std::max<std::int64_t>(1 << 16, before + after);
        std::vector<double> raw_c;
        std::vector<double> raw_d;
        for (std::int64_t at = begin; at < end; at += block) {
            const std::int64_t length = std::min(block, end - at);
            raw_c.resize(static_cast<std::size_t>(before + length + after));
            raw_d.resize(raw_c.size());
            TRY(source->read(at - before, raw_c, raw_d));
            std::copy_n(raw_c.begin() + before, length, c.begin() + (at - first));
            delay.apply(
                raw_d, before,
                d.subspan(static_cast<std::size_t>(at - first), static_cast<std::size_t>(length)));
        }
        return {};
    };
    return source_of(frames, source->seeks(), read);
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
