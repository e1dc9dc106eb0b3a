#include "core/track/trend.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

constexpr std::size_t least_windows = 3;
constexpr double significant = 3;  // standard deviations of chi^2 per degree of freedom
constexpr double decays_from = 2;  // standard deviations of the slope

struct Point {
    double time_s;
    double value;
    double sd;
    double noise;  // of its window, from which the deviation was made
    double weight = 0;
};

bool counts(Flags flags) {
    return !has(flags, Flag::gap) && !has(flags, Flag::clipped) &&
           !has(flags, Flag::filter_transient) && !has(flags, Flag::delay_reach) &&
           !has(flags, Flag::not_converged) && !has(flags, Flag::at_bound);
}

std::vector<Point> points(const Track& track, SlowVariable variable, double from_s, double to_s,
                          std::size_t apart, TrendOf of) {
    constexpr double turn = 2 * std::numbers::pi;
    const bool wrapped = variable == SlowVariable::delta_phi_CD || variable == SlowVariable::alpha;
    const auto times = track.time_s();
    const auto values = track.values(variable);
    const auto sds = track.sds(variable);
    const auto noise = track.values(SlowVariable::noise);
    const auto first =
        static_cast<std::size_t>(std::ranges::lower_bound(times, from_s) - times.begin());
    std::vector<Point> found;
    for (std::size_t k = first; k < times.size() && times[k] <= to_s;) {
        double value = values[k];
        double sd = sds[k];
        if (of == TrendOf::logarithm) {
            sd /= value;
            value = std::log(value);
        }
        if (!counts(track.flags()[k]) || !std::isfinite(value) || !(sd > 0)) {
            ++k;
            continue;
        }
        if (wrapped && !found.empty()) {
            value -= turn * std::round((value - found.back().value) / turn);
        }
        found.push_back({times[k], value, sd, noise[k]});
        k += apart;
    }
    return found;
}

// The noise of a short window is known poorly, and weights that follow its scatter would favour the
// windows whose deviation comes out too small: the windows share the mean square of their noise.
void weigh(std::vector<Point>& points) {
    double squares = 0;
    for (const Point& p : points) {
        squares += p.noise * p.noise;
    }
    const double common = std::sqrt(squares / static_cast<double>(points.size()));
    for (Point& p : points) {
        const double scale = common > 0 && p.noise > 0 ? common / p.noise : 1;
        p.weight = 1 / (p.sd * p.sd * scale * scale);
    }
}

}  // namespace

std::optional<Trend> line_trend(const Track& track, SlowVariable variable, double from_s,
                                double to_s, std::size_t apart, TrendOf of) {
    if (track.sds(variable).empty()) {
        return std::nullopt;
    }
    std::vector<Point> found = points(track, variable, from_s, to_s, apart, of);
    if (found.size() < least_windows) {
        return std::nullopt;
    }
    weigh(found);
    Trend trend;
    trend.windows = found.size();
    // About the first point: times and frequencies are large against what they change by.
    double weight = 0;
    double time = 0;
    double value = 0;
    for (const Point& p : found) {
        weight += p.weight;
        time += p.weight * (p.time_s - found[0].time_s);
        value += p.weight * (p.value - found[0].value);
    }
    time /= weight;
    value /= weight;
    double spread = 0;
    double common = 0;
    for (const Point& p : found) {
        const double t = p.time_s - found[0].time_s - time;
        spread += p.weight * t * t;
        common += p.weight * t * (p.value - found[0].value - value);
    }
    trend.centre_s = found[0].time_s + time;
    trend.value = found[0].value + value;
    trend.slope_per_s = common / spread;
    double chi2 = 0;
    for (const Point& p : found) {
        const double off = p.value - trend.at(p.time_s);
        chi2 += p.weight * off * off;
    }
    const auto dof = static_cast<double>(found.size() - 2);
    trend.chi2_per_dof = chi2 / dof;
    const bool scatters = trend.chi2_per_dof > 1 + significant * std::sqrt(2 / dof);
    const double larger = scatters ? std::sqrt(trend.chi2_per_dof) : 1;
    trend.sd_value = larger / std::sqrt(weight);
    trend.sd_slope_per_s = larger / std::sqrt(spread);
    return trend;
}

std::size_t windows_apart(std::int64_t length, std::int64_t hop) {
    return static_cast<std::size_t>(std::max<std::int64_t>((length + hop - 1) / hop, 1));
}

std::optional<DecayTime> decay_time(const Trend& of_logarithm) {
    const double rate = -of_logarithm.slope_per_s;
    if (!(rate > decays_from * of_logarithm.sd_slope_per_s)) {
        return std::nullopt;
    }
    return DecayTime{1 / rate, of_logarithm.sd_slope_per_s / (rate * rate)};
}

}  // namespace vybeg
