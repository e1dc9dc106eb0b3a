#include "core/track/track_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vybeg {

TrackSummary summarise(const Track& track, double independent) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    TrackSummary summary{
        .windows = track.rows(), .mean_f_hz = nan, .sd_mean_f_hz = nan, .rms = nan};
    const auto f = track.values(SlowVariable::f);
    const auto rms = track.values(SlowVariable::rms);
    const auto flags = track.flags();
    const auto harmless = static_cast<Flags>(Flag::no_quadrature);

    // Welford's recurrence: the frequencies agree to seven digits and more, and a difference of
    // sums of squares would lose the scatter.
    double count = 0;
    double mean = 0;
    double spread = 0;
    double squares = 0;
    double errors = 0;
    for (std::size_t k = 0; k < track.rows(); ++k) {
        summary.flagged += (flags[k] & static_cast<Flags>(~harmless)) != 0 ? 1 : 0;
        if (std::isfinite(f[k]) && !has(flags[k], Flag::gap)) {
            count += 1;
            const double step = f[k] - mean;
            mean += step / count;
            spread += step * (f[k] - mean);
        }
        if (std::isfinite(rms[k])) {
            errors += 1;
            squares += rms[k] * rms[k];
        }
    }
    if (count > 0) {
        summary.mean_f_hz = mean;
    }
    if (count > 1) {
        summary.sd_mean_f_hz =
            std::sqrt(spread / (count - 1) / (count * std::min(1.0, independent)));
    }
    if (errors > 0) {
        summary.rms = std::sqrt(squares / errors);
    }
    return summary;
}

}  // namespace vybeg
