#include "core/analysis/analyse.h"

#include "core/analysis/estimate_track.h"
#include "core/analysis/prepare.h"
#include "core/base/number_text.h"
#include "core/track/unwrap.h"

#include <tbb/info.h>

#include <algorithm>
#include <numbers>

namespace vybeg {
namespace {

Result<WindowPlan> plan_of(const Settings& settings, const Prepared& prepared,
                           const Recording& recording) {
    const double rate = recording.rate_hz;
    std::int64_t length = settings.periods
                              ? window_of_periods(*settings.periods, prepared.f0_hz, rate)
                              : settings.window;
    const std::int64_t least = least_window(prepared.f0_hz, rate);
    if (length < least) {
        return Error{ErrorCode::window_too_short,
                     recording_name(recording),
                     {integer_text(length), integer_text(least)}};
    }
    if (settings.snap) {
        length = snap_window(length, prepared.f0_hz, rate);
    }
    const std::int64_t hop = settings.hop > 0 ? settings.hop : length;
    const WindowPlan plan = plan_windows(prepared.first, prepared.end, length, hop);
    if (plan.count == 0) {
        return Error{ErrorCode::window_too_long,
                     recording_name(recording),
                     {integer_text(length), integer_text(prepared.end - prepared.first)}};
    }
    return plan;
}

void add_flag_diagnostics(Analysis& analysis, std::int64_t context) {
    const auto flags = analysis.track.flags();
    const auto flagged = std::count_if(flags.begin(), flags.end(),
                                       [](Flags f) { return has(f, Flag::not_converged); });
    if (flagged > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::not_converged,
             {integer_text(flagged), integer_text(analysis.plan.count)}});
    }
    if (context > 0) {
        analysis.diagnostics.push_back({DiagnosticKind::context_missing, {integer_text(context)}});
    }
}

}  // namespace

Result<Analysis> analyse(const Recording& recording, const Settings& settings,
                         const JobControl& job) {
    if (const Status valid = validate(settings); !valid) {
        return valid.error();
    }
    const Result<Prepared> prepared = prepare(recording, settings, job);
    if (!prepared) {
        return prepared.error();
    }
    const Result<WindowPlan> plan = plan_of(settings, *prepared, recording);
    if (!plan) {
        return plan.error();
    }
    const int cores = tbb::info::default_concurrency();
    const int threads = settings.threads > 0 ? std::min(settings.threads, cores) : cores;
    Result<EstimatedTrack> estimated =
        estimate_track(*prepared, *plan, settings, recording.rate_hz, threads, job);
    if (!estimated) {
        return estimated.error();
    }

    Analysis analysis;
    analysis.track = std::move(estimated->track);
    unwrap_angle(analysis.track, prepared->calibration.angle_zero_deg * std::numbers::pi / 90);
    analysis.settings = settings;
    analysis.settings.window = plan->length;
    analysis.settings.hop = plan->hop;
    analysis.settings.f0_hz = prepared->f0_hz;
    analysis.settings.calibration = prepared->calibration;
    analysis.plan = *plan;
    analysis.residual = orthogonality_residual(plan->length, prepared->f0_hz, recording.rate_hz);
    analysis.diagnostics = prepared->diagnostics;
    add_flag_diagnostics(analysis, estimated->context);
    analysis.timing = {estimated->read_s, prepared->carrier_s, estimated->estimate_s, threads};
    return analysis;
}

Result<double> find_recording_carrier(const Recording& recording, const Settings& settings,
                                      const JobControl& job) {
    if (const Status valid = validate(settings); !valid) {
        return valid.error();
    }
    const Result<Prepared> prepared = prepare(recording, settings, job);
    if (!prepared) {
        return prepared.error();
    }
    return prepared->f0_hz;
}

}  // namespace vybeg
