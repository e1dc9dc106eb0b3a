#include "core/residuals/residual_samples.h"

#include "core/residuals/signal_curves.h"
#include "core/residuals/window_wave.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace vybeg {
namespace {

constexpr std::int64_t most_frames = std::int64_t{1} << 20;
constexpr std::int64_t block_frames = std::int64_t{1} << 16;

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
    // Of an analysis that outlives this function.
    const auto source =
        TRY(signal_source(recording, {std::shared_ptr<const Analysis>(), &analysis}, job));
    const Frames all = frames_of(range, analysis.plan, recording.rate_hz);
    ResidualSamples found;
    found.frames = all.count();
    const auto expected = static_cast<std::size_t>(std::min(all.count(), most_frames));
    found.c.reserve(expected);
    found.d.reserve(expected);
    const bool whole = all.count() <= most_frames;
    const std::int64_t blocks =
        whole ? (all.count() + block_frames - 1) / block_frames : most_frames / block_frames;
    bool in_part = false;
    std::int64_t next = all.first;  // frame that continues the part
    for (std::int64_t b = 0; b < blocks; ++b) {
        const std::int64_t first =
            all.first +
            (whole ? b * block_frames : (all.count() - block_frames) / (blocks - 1) * b);
        const auto block = TRY(signal_excerpt(
            source, first, std::min(block_frames, all.end - first), job, range.window));
        in_part = in_part && first == next;
        next = first + static_cast<std::int64_t>(block.size());
        found.examined += next - first;
        for (std::size_t k = 0; k < block.size(); ++k) {
            const double c = block.residual_c(k);
            const double d = block.residual_d(k);
            if (!std::isfinite(c) || !std::isfinite(d)) {
                ++found.without;
                in_part = false;
                continue;
            }
            if (!in_part) {
                found.part_begins.push_back(found.c.size());
                in_part = true;
            }
            found.c.push_back(c);
            found.d.push_back(d);
        }
        job.report(static_cast<double>(b + 1) / static_cast<double>(blocks));
    }
    return found;
}

}  // namespace vybeg
