#include "ui/values/covered_time.h"

namespace vybeg::ui {

bool covers(const Analysis& analysis, double time_s) {
    const auto times = analysis.track.time_s();
    if (times.size() < 2) {
        return !times.empty();
    }
    const double window_s = (times[1] - times[0]) * static_cast<double>(analysis.plan.length) /
                            static_cast<double>(analysis.plan.hop);
    return time_s >= times.front() - window_s && time_s <= times.back() + window_s;
}

}  // namespace vybeg::ui
