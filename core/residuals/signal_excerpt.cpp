#include "core/residuals/signal_excerpt.h"

#include "core/analysis/prepare.h"
#include "core/residuals/window_wave.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

void fit(const Analysis& analysis, SignalExcerpt& excerpt) {
    const WindowPlan& plan = analysis.plan;
    const std::int64_t end = excerpt.first + std::ssize(excerpt.c);
    if (plan.count == 0) {
        return;
    }
    for (std::int64_t window = window_about(plan, excerpt.first); window < plan.count; ++window) {
        Frames own = own_frames(plan, window);
        if (own.first >= end) {
            break;
        }
        own = {std::max(own.first, excerpt.first), std::min(own.end, end)};
        const WindowWave wave(analysis, window, excerpt.rate_hz);
        for (std::int64_t frame = own.first; frame < own.end; ++frame) {
            const auto k = static_cast<std::size_t>(frame - excerpt.first);
            const SignalPair value = wave.at(static_cast<double>(frame));
            excerpt.fit_c[k] = value.c;
            excerpt.fit_d[k] = value.d;
        }
    }
}

}  // namespace

Result<SignalSource> signal_source(const Recording& recording,
                                   std::shared_ptr<const Analysis> analysis,
                                   const JobControl& job) {
    if (!analysis) {
        return SignalSource{recording.source, recording.rate_hz, nullptr};
    }
    // Carrier and offsets are in the settings as used, so that nothing is searched again.
    const auto prepared = TRY(prepare(recording, analysis->settings, job.silent()));
    return SignalSource{prepared.ahead, recording.rate_hz, std::move(analysis)};
}

Result<SignalExcerpt> signal_excerpt(const SignalSource& source, std::int64_t first,
                                     std::int64_t count, const JobControl& job) {
    TRY(job.go_on());
    SignalExcerpt excerpt;
    excerpt.first = std::clamp<std::int64_t>(first, 0, source.samples->frames());
    excerpt.rate_hz = source.rate_hz;
    const std::int64_t end = std::clamp(first + count, excerpt.first, source.samples->frames());
    const auto size = static_cast<std::size_t>(end - excerpt.first);
    excerpt.c.resize(size);
    excerpt.d.resize(size);
    if (size > 0) {
        TRY(source.samples->read(excerpt.first, excerpt.c, excerpt.d));
    }
    excerpt.fit_c.assign(size, std::numeric_limits<double>::quiet_NaN());
    excerpt.fit_d = excerpt.fit_c;
    if (source.analysis) {
        fit(*source.analysis, excerpt);
    }
    return excerpt;
}

}  // namespace vybeg
