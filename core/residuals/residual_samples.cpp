#include "core/residuals/residual_samples.h"

#include "core/analysis/prepare.h"
#include "core/residuals/window_wave.h"

#include <algorithm>
#include <cmath>

namespace vybeg {
namespace {

constexpr std::int64_t most_frames = std::int64_t{1} << 20;
constexpr std::int64_t block_frames = std::int64_t{1} << 16;

class Collector {
public:
    Collector(const Recording& recording, const Analysis& analysis, const SampleSource& source,
              ResidualSamples& found)
        : analysis_(analysis), rate_hz_(recording.rate_hz), source_(source), found_(found) {}

    // Frames of one block; `only`: with the wave of this window.
    Status take(const Frames& block, std::optional<std::int64_t> only) {
        c_.resize(static_cast<std::size_t>(block.count()));
        d_.resize(c_.size());
        TRY(source_.read(block.first, c_, d_));
        const WindowPlan& plan = analysis_.plan;
        found_.examined += block.count();
        std::int64_t at = block.first;
        for (std::int64_t window = only.value_or(window_about(plan, at));
             at < block.end && window < plan.count; ++window) {
            Frames own = only ? block : own_frames(plan, window);
            if (own.first >= block.end) {
                break;
            }
            own = {std::max(own.first, at), std::min(own.end, block.end)};
            if (own.count() > 0) {
                found_.without += own.first - at;
                take_window(own, block.first, WindowWave(analysis_, window, rate_hz_));
                at = own.end;
            }
        }
        found_.without += block.end - at;
        return {};
    }

private:
    void take_window(const Frames& frames, std::int64_t first, const WindowWave& wave) {
        if (!wave.exists()) {
            found_.without += frames.count();
            in_part_ = false;
            return;
        }
        if (frames.first != next_) {
            in_part_ = false;
        }
        for (std::int64_t frame = frames.first; frame < frames.end; ++frame) {
            const double c = c_[static_cast<std::size_t>(frame - first)];
            const double d = d_[static_cast<std::size_t>(frame - first)];
            if (!std::isfinite(c) || !std::isfinite(d)) {
                ++found_.without;
                in_part_ = false;
                continue;
            }
            const SignalPair fitted = wave.at(static_cast<double>(frame));
            if (!in_part_) {
                found_.part_begins.push_back(found_.c.size());
                in_part_ = true;
            }
            found_.c.push_back(c - fitted.c);
            found_.d.push_back(d - fitted.d);
        }
        next_ = frames.end;
    }

    const Analysis& analysis_;
    double rate_hz_;
    const SampleSource& source_;
    ResidualSamples& found_;
    std::vector<double> c_;
    std::vector<double> d_;
    bool in_part_ = false;
    std::int64_t next_ = -1;  // frame that continues the part
};

Frames frames_of(const ResidualRange& range, const WindowPlan& plan, double rate_hz) {
    if (range.window) {
        return {plan.start(*range.window), plan.start(*range.window) + plan.length};
    }
    const Frames all{plan.first, plan.start(plan.count - 1) + plan.length};
    const auto frame_at = [&](double seconds) {
        return std::clamp(seconds * rate_hz, static_cast<double>(all.first),
                          static_cast<double>(all.end));
    };
    const auto last = static_cast<std::int64_t>(std::floor(frame_at(range.time.to_s) + 1e-6));
    return {static_cast<std::int64_t>(std::ceil(frame_at(range.time.from_s) - 1e-6)),
            std::min(last + 1, all.end)};
}

}  // namespace

Result<ResidualSamples> residual_samples(const Recording& recording, const Analysis& analysis,
                                         const ResidualRange& range, const JobControl& job) {
    // Carrier and offsets are in the settings as used, so that nothing is searched again.
    const auto prepared = TRY(prepare(recording, analysis.settings, job.silent()));
    const Frames all = frames_of(range, analysis.plan, recording.rate_hz);
    ResidualSamples found;
    found.frames = all.count();
    const auto expected = static_cast<std::size_t>(std::min(all.count(), most_frames));
    found.c.reserve(expected);
    found.d.reserve(expected);
    const bool whole = all.count() <= most_frames;
    const std::int64_t blocks =
        whole ? (all.count() + block_frames - 1) / block_frames : most_frames / block_frames;
    Collector collector(recording, analysis, *prepared.ahead, found);
    for (std::int64_t b = 0; b < blocks; ++b) {
        TRY(job.go_on());
        const std::int64_t first =
            all.first +
            (whole ? b * block_frames : (all.count() - block_frames) / (blocks - 1) * b);
        const Frames block{first, std::min(first + block_frames, all.end)};
        TRY(collector.take(block, range.window));
        job.report(static_cast<double>(b + 1) / static_cast<double>(blocks));
    }
    return found;
}

}  // namespace vybeg
