#include "core/recording/samples/delayed_source.h"

#include "core/numerics/fractional_delay.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

class DelayedSource final : public SampleSource {
public:
    DelayedSource(std::shared_ptr<const SampleSource> source, double delay_samples)
        : source_(std::move(source)), delay_(delay_samples) {}

    std::int64_t frames() const override { return source_->frames(); }
    bool seeks() const override { return source_->seeks(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        const std::int64_t before = delay_.reach_before();
        const std::int64_t after = delay_.reach_after();
        std::ranges::fill(c, missing);
        std::ranges::fill(d, missing);
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

std::shared_ptr<const SampleSource> delayed_source(std::shared_ptr<const SampleSource> source,
                                                   double delay_samples) {
    // A shift by the whole recording leaves as little of it as any larger one.
    const auto frames = static_cast<double>(source->frames());
    const double delay = std::clamp(delay_samples, -frames, frames);
    return std::make_shared<DelayedSource>(std::move(source), delay);
}

}  // namespace vybeg
