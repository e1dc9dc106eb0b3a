#include "core/recording/samples/sample_source.h"

#include "core/numerics/fractional_delay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vybeg {
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

std::shared_ptr<const SampleSource> memory_source(std::vector<double> c, std::vector<double> d) {
    const std::int64_t frames = std::ssize(c);
    return source_of(frames, true,
                     [c = std::move(c), d = std::move(d)](
                         std::int64_t first, std::span<double> out_c, std::span<double> out_d) {
                         std::copy_n(c.begin() + first, out_c.size(), out_c.begin());
                         std::copy_n(d.begin() + first, out_d.size(), out_d.begin());
                         return Status();
                     });
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

namespace {

// Delays of the frames, one for each piece of them: pieces do not depend on the range that is read.
class Delays {
public:
    Delays(double samples, double drift, std::int64_t frames)
        : samples_(samples), drift_(drift), most_(static_cast<double>(frames)) {
        // A shift by the whole recording leaves as little of it as any larger one.
        if (drift == 0) {
            filters_.emplace_back(std::clamp(samples, -most_, most_));
            return;
        }
        piece_ = std::clamp<std::int64_t>(std::llround(step / std::abs(drift)), 1, frames + 1);
        for (int k = 0; k <= fractions; ++k) {
            filters_.emplace_back(static_cast<double>(k) / fractions - 0.5);
        }
    }

    struct Delay {
        const FractionalDelay& fraction;
        std::int64_t whole;

        std::int64_t before() const {
            return std::max<std::int64_t>(fraction.reach_before() + whole, 0);
        }
        std::int64_t after() const {
            return std::max<std::int64_t>(fraction.reach_after() - whole, 0);
        }
    };
    Delay at(std::int64_t frame) const {
        if (drift_ == 0) {
            return {filters_.front(), 0};
        }
        const double middle =
            static_cast<double>(frame / piece_ * piece_) + static_cast<double>(piece_ - 1) / 2;
        const double delay = std::clamp(samples_ + drift_ * middle, -most_, most_);
        const double whole = std::floor(delay + 0.5);
        const auto place = static_cast<std::size_t>(std::lround((delay - whole + 0.5) * fractions));
        return {filters_[place], static_cast<std::int64_t>(whole)};
    }
    bool move() const { return piece_ > 0; }
    // The frame after those of one delay.
    std::int64_t piece_end(std::int64_t frame) const {
        return !move() ? std::numeric_limits<std::int64_t>::max() : (frame / piece_ + 1) * piece_;
    }

private:
    static constexpr double step = 2e-4;  // samples
    static constexpr int fractions = 5000;

    double samples_;
    double drift_;
    double most_;
    std::int64_t piece_ = 0;  // frames of one delay; 0: all
    std::vector<FractionalDelay> filters_;
};

}  // namespace

std::shared_ptr<const SampleSource> delayed_source(std::shared_ptr<const SampleSource> source,
                                                   double delay_samples, double drift) {
    const std::int64_t frames = source->frames();
    const auto delays = std::make_shared<const Delays>(delay_samples, drift, frames);
    const auto read = [source, frames, delays](std::int64_t first, std::span<double> c,
                                               std::span<double> d) -> Status {
        std::ranges::fill(c, missing_sample);
        std::ranges::fill(d, missing_sample);
        const std::int64_t end = first + std::ssize(c);
        std::vector<double> raw_c;
        std::vector<double> raw_d;
        for (std::int64_t at = first; at < end;) {
            // Blocks bound the memory of a long read, and are always long against the frames that
            // are read twice. Within a block the delay changes by less than a filter's length.
            const std::int64_t beside = delays->move() ? 64 : 0;
            const Delays::Delay nearly = delays->at(at);
            const std::int64_t block_end = std::min(
                at + std::max<std::int64_t>(1 << 16, nearly.before() + nearly.after()), end);
            const Delays::Delay last = delays->at(block_end - 1);
            const std::int64_t from =
                std::max<std::int64_t>(at - std::max(nearly.before(), last.before()) - beside, 0);
            const std::int64_t to =
                std::min(block_end + std::max(nearly.after(), last.after()) + beside, frames);
            raw_c.resize(static_cast<std::size_t>(std::max<std::int64_t>(to - from, 0)));
            raw_d.resize(raw_c.size());
            TRY(source->read(from, raw_c, raw_d));
            while (at < block_end) {
                const Delays::Delay delay = delays->at(at);
                const std::int64_t piece_end = std::min(delays->piece_end(at), block_end);
                const std::int64_t begin = std::max(at, delay.before());
                const std::int64_t count = std::min(piece_end, frames - delay.after()) - begin;
                if (count > 0) {
                    std::copy_n(raw_c.begin() + (begin - from), count, c.begin() + (begin - first));
                    delay.fraction.apply(raw_d, begin - from - delay.whole,
                                         d.subspan(static_cast<std::size_t>(begin - first),
                                                   static_cast<std::size_t>(count)));
                }
                at = piece_end;
            }
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
