#include "core/analysis/analysis_plan.h"

#include "core/base/number_text.h"

namespace vybeg {

Result<WindowPlan> plan_of(const WindowSettings& settings, const ConditionedRecording& prepared,
                           const Recording& recording) {
    const double rate = recording.rate_hz;
    std::int64_t length = settings.periods
                              ? window_of_periods(*settings.periods, prepared.f0_hz, rate)
                              : settings.window;
    const std::int64_t least = least_window(prepared.f0_hz, rate);
    if (length < least) {
        return Error{ErrorCode::window_too_short,
                     recording_name(recording),
                     {count_arg(length), count_arg(least)}};
    }
    if (settings.snap) {
        length = snap_window(length, prepared.f0_hz, rate);
    }
    const std::int64_t hop = settings.hop > 0 ? settings.hop : length;
    const WindowPlan plan = plan_windows(prepared.first, prepared.end, length, hop);
    if (plan.count == 0) {
        return Error{ErrorCode::window_too_long,
                     recording_name(recording),
                     {count_arg(length), count_arg(prepared.end - prepared.first)}};
    }
    return plan;
}

}  // namespace vybeg
