#include "core/recording/conditioning/gapped_source.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// A segment of the source's frames and where it lies when the gaps before it are in.
struct Segment {
    std::int64_t source_first = 0;
    std::int64_t first = 0;
    std::int64_t count = 0;
};

class GappedSource final : public SampleSource {
public:
    GappedSource(std::shared_ptr<const SampleSource> source, std::span<const PhaseStep> steps)
        : source_(std::move(source)) {
        std::int64_t from = 0;
        std::int64_t inserted = 0;
        for (const PhaseStep& step : steps) {
            if (step.lost > 0) {
                segments_.push_back({from, from + inserted, step.frame - from});
                from = step.frame;
                inserted += step.lost;
            }
        }
        segments_.push_back({from, from + inserted, source_->frames() - from});
        frames_ = source_->frames() + inserted;
    }

    std::int64_t frames() const override { return frames_; }
    bool seeks() const override { return source_->seeks(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        std::ranges::fill(c, std::numeric_limits<double>::quiet_NaN());
        std::ranges::fill(d, std::numeric_limits<double>::quiet_NaN());
        const std::int64_t end = first + static_cast<std::int64_t>(c.size());
        const auto ends_behind = [](std::int64_t frame, const Segment& segment) {
            return frame < segment.first + segment.count;
        };
        auto segment = std::upper_bound(segments_.begin(), segments_.end(), first, ends_behind);
        for (; segment != segments_.end() && segment->first < end; ++segment) {
            const std::int64_t from = std::max(first, segment->first);
            const std::int64_t to = std::min(end, segment->first + segment->count);
            const auto at = static_cast<std::size_t>(from - first);
            const auto count = static_cast<std::size_t>(to - from);
            TRY(source_->read(segment->source_first + from - segment->first, c.subspan(at, count),
                              d.subspan(at, count)));
        }
        return {};
    }

private:
    std::shared_ptr<const SampleSource> source_;
    std::vector<Segment> segments_;
    std::int64_t frames_ = 0;
};

}  // namespace

std::shared_ptr<const SampleSource> with_gaps(std::shared_ptr<const SampleSource> source,
                                              std::span<const PhaseStep> steps) {
    if (std::ranges::none_of(steps, [](const PhaseStep& step) { return step.lost > 0; })) {
        return source;
    }
    return std::make_shared<GappedSource>(std::move(source), steps);
}

}  // namespace vybeg
