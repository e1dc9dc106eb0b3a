#include "core/track/trend.h"

#include "core/track/trend_points.h"

#include <cmath>

namespace vybeg {
namespace {

constexpr std::size_t least_trend_windows = 3;
constexpr double decays_from = 2;  // standard deviations of the slope

}  // namespace

std::optional<Trend> line_trend(const Track& track, SlowVariable variable, double from_s,
                                double to_s, std::size_t apart, TrendOf of) {
    const std::vector<TrendPoint> found = trend_points(track, variable, from_s, to_s, apart, of);
    if (found.size() < least_trend_windows) {
        return std::nullopt;
    }
    Trend trend;
    trend.windows = found.size();
    // About the first point: times and frequencies are large against what they change by.
    double weight = 0;
    double time = 0;
    double value = 0;
    for (const TrendPoint& p : found) {
        weight += p.weight;
        time += p.weight * (p.time_s - found[0].time_s);
        value += p.weight * (p.value - found[0].value);
    }
    time /= weight;
    value /= weight;
    double spread = 0;
    double common = 0;
    for (const TrendPoint& p : found) {
        const double t = p.time_s - found[0].time_s - time;
        spread += p.weight * t * t;
        common += p.weight * t * (p.value - found[0].value - value);
    }
    trend.centre_s = found[0].time_s + time;
    trend.value = found[0].value + value;
    trend.slope_per_s = common / spread;
    const Scatter scatter =
        scatter_about(found, 2, [&trend](double time_s) { return trend.at(time_s); });
    trend.chi2_per_dof = scatter.chi2_per_dof;
    trend.enlargement = scatter.enlargement;
    trend.sd_value = trend.enlargement / std::sqrt(weight);
    trend.sd_slope_per_s = trend.enlargement / std::sqrt(spread);
    return trend;
}

std::optional<DecayTime> decay_time(const Trend& of_logarithm) {
    const double rate = -of_logarithm.slope_per_s;
    if (!(rate > decays_from * of_logarithm.sd_slope_per_s)) {
        return std::nullopt;
    }
    return DecayTime{1 / rate, of_logarithm.sd_slope_per_s / (rate * rate)};
}

}  // namespace vybeg
