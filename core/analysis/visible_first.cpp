#include "core/analysis/visible_first.h"

#include "core/analysis/analyse.h"
#include "core/analysis/estimate_track.h"
#include "core/analysis/prepare.h"
#include "core/numerics/phase.h"
#include "core/track/unwrap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

// Seconds below which nobody waits: everything is made at once.
constexpr double at_once_s = 0.1;
// Seconds that the spread windows may take. Each step doubles their number, so that a slow disk or
// a long window gives a coarser first picture, not a late one.
constexpr double spread_s = 0.06;
constexpr std::int64_t fewest_spread = 16;
constexpr std::int64_t most_spread = 512;

// Windows [first, end) of a plan.
struct WindowRange {
    std::int64_t first = 0;
    std::int64_t end = 0;

    std::int64_t count() const { return end - first; }
};

// About how long windows take, s: a window and a frame of an ordinary processor core. It decides
// what is shown when, nothing else.
double about_s(std::int64_t windows, const WindowPlan& plan, Algorithm algorithm) {
    const double window_s = algorithm == Algorithm::conjugate_gradient ? 5e-6 : 0.2e-6;
    const double frame_s = 15e-9;
    const auto count = static_cast<double>(windows);
    return count * (window_s + frame_s * static_cast<double>(plan.hop));
}

// The windows whose centres are visible.
WindowRange visible_windows(const WindowPlan& plan, const TimeRange& visible, double rate_hz) {
    const auto windows = static_cast<double>(plan.count);
    const auto window_at = [&](double time_s) {
        const double hops = (time_s - plan.centre_s(0, rate_hz)) * rate_hz;
        return std::clamp(hops / static_cast<double>(plan.hop), -1.0, windows);
    };
    const auto first = static_cast<std::int64_t>(std::ceil(window_at(visible.from_s)));
    const auto last = static_cast<std::int64_t>(std::floor(window_at(visible.to_s)));
    const WindowRange shown{std::clamp<std::int64_t>(first, 0, plan.count),
                            std::clamp<std::int64_t>(last + 1, 0, plan.count)};
    return shown.count() > 0 ? shown : WindowRange{};
}

// Windows of an analysis by themselves, before all of them are made.
class EarlyWindows {
public:
    EarlyWindows(ConditionedRecording prepared, const AnalysisSummary& whole, double rate_hz,
                 const JobControl& job)
        : prepared_(std::move(prepared)), whole_(whole), rate_hz_(rate_hz), job_(job.silent()) {}

    // Single windows at even distances, first and last included, as many as there is time for.
    Status spread(const WindowRange& segment) {
        const double begun = job_.now();
        for (std::int64_t places = fewest_spread; places <= most_spread; places *= 2) {
            for (std::int64_t place = 0; place <= places; ++place) {
                const std::int64_t window = segment.first + (segment.count() - 1) * place / places;
                if (rows_.contains(window)) {
                    continue;
                }
                if (places > fewest_spread && job_.now() - begun > spread_s / 2) {
                    return {};
                }
                TRY(estimate({window, window + 1}, 1));
            }
        }
        return {};
    }

    // All of them.
    Status fill(const WindowRange& segment) {
        rows_.erase(rows_.lower_bound(segment.first), rows_.lower_bound(segment.end));
        return estimate(segment, threads_of(whole_.settings.threads));
    }

    Analysis analysis() const {
        Analysis analysis{whole_, {}};
        analysis.timing = {};
        for (const auto& [window, rows] : rows_) {
            analysis.track.append(rows);
        }
        // The first electrode's angle has been taken off with the rows' own.
        unwrap_angle(analysis.track, 0);
        return analysis;
    }

private:
    Status estimate(const WindowRange& segment, int threads) {
        const WindowPlan part{whole_.plan.start(segment.first), whole_.plan.length, whole_.plan.hop,
                              segment.count()};
        Settings settings = whole_.settings;
        if (settings.initial) {
            // Typed start values hold at the first window of the whole.
            const double later = part.centre_s(0, rate_hz_) - whole_.plan.centre_s(0, rate_hz_);
            double& alpha = settings.initial->state.alpha;
            alpha = wrap(alpha - 2 * std::numbers::pi * settings.initial->f_hz * later);
        }
        Track& rows = rows_[segment.first];
        const TrackSink collect = [&rows](const Track& more) {
            rows.append(more);
            return Status{};
        };
        TRY(estimate_track(prepared_, part, settings, rate_hz_, threads, collect, job_));
        return {};
    }

    ConditionedRecording prepared_;
    const AnalysisSummary& whole_;
    double rate_hz_;
    JobControl job_;
    std::map<std::int64_t, Track> rows_;  // by their first window
};

Status show_early(const ConditionedRecording& prepared, const AnalysisSummary& whole,
                  double rate_hz, const TimeRange& visible, const EarlySink& early,
                  const JobControl& job) {
    const WindowPlan& plan = whole.plan;
    EarlyWindows windows(prepared.past_check(), whole, rate_hz, job);
    TRY(windows.spread({0, plan.count}));
    const WindowRange shown = visible_windows(plan, visible, rate_hz);
    const bool is_part = shown.count() > 0 && 2 * shown.count() <= plan.count;
    const bool is_quick = about_s(shown.count(), plan, whole.settings.algorithm) < at_once_s;
    if (is_part && !is_quick) {
        TRY(windows.spread(shown));
    }
    if (!is_part || !is_quick) {
        early(windows.analysis());
    }
    if (is_part) {
        TRY(windows.fill(shown));
        early(windows.analysis());
    }
    return {};
}

}  // namespace

Result<Analysis> analyse_visible_first(const Recording& recording, const Settings& settings,
                                       const TimeRange& visible, const EarlySink& early,
                                       const JobControl& job) {
    const BeforeWindows show = [&](const ConditionedRecording& prepared,
                                   const AnalysisSummary& whole) {
        // Repairing lost samples goes through the whole recording before the first window: nothing
        // of it could be early.
        const bool long_enough =
            about_s(whole.plan.count, whole.plan, settings.algorithm) > at_once_s;
        return !settings.repair_lost && long_enough
                   ? show_early(prepared, whole, recording.rate_hz, visible, early, job)
                   : Status();
    };
    return analyse(recording, settings, job, show);
}

}  // namespace vybeg
