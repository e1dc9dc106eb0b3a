#include "core/track/trend_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

constexpr double significant = 3;  // standard deviations of chi^2 per degree of freedom
constexpr std::size_t most_groups = 24;
constexpr std::size_t least_in_group = 4;  // points

struct Measured {
    double time_s;
    double value;
    double sd;
};

bool counts(Flags flags) {
    return !has(flags, Flag::gap) && !has(flags, Flag::clipped) &&
           !has(flags, Flag::filter_transient) && !has(flags, Flag::delay_reach) &&
           !has(flags, Flag::not_converged) && !has(flags, Flag::at_bound);
}

std::vector<Measured> measured(const Track& track, SlowVariable variable, double from_s,
                               double to_s, std::size_t apart, TrendOf of) {
    constexpr double turn = 2 * std::numbers::pi;
    const bool wrapped = variable == SlowVariable::delta_phi_CD || variable == SlowVariable::alpha;
    const auto times = track.time_s();
    const auto values = track.values(variable);
    const auto sds = track.sds(variable);
    const auto first =
        static_cast<std::size_t>(std::ranges::lower_bound(times, from_s) - times.begin());
    std::vector<Measured> found;
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
        found.push_back({times[k], value, sd});
        k += apart;
    }
    return found;
}

}  // namespace

std::vector<TrendPoint> trend_points(const Track& track, SlowVariable variable, double from_s,
                                     double to_s, std::size_t apart, TrendOf of) {
    if (track.sds(variable).empty()) {
        return {};
    }
    const std::vector<Measured> windows = measured(track, variable, from_s, to_s, apart, of);
    // Each window with its own deviation: that of a short one rests on a hundred degrees of
    // freedom, too, so that weights do not favour windows whose deviations are too small by chance.
    std::vector<TrendPoint> points;
    points.reserve(windows.size());
    for (const Measured& window : windows) {
        points.push_back({window.time_s, window.value, 1 / (window.sd * window.sd)});
    }
    return points;
}

Scatter scatter_about(const std::vector<TrendPoint>& points, int parameters,
                      const std::function<double(double)>& trend) {
    const std::size_t groups = std::min(most_groups, points.size() / least_in_group);
    double chi2 = 0;
    double chi2_of_means = 0;
    for (std::size_t group = 0, k = 0; group < std::max<std::size_t>(groups, 1); ++group) {
        const std::size_t end = groups == 0 ? points.size() : (group + 1) * points.size() / groups;
        double weight = 0;
        double off = 0;
        for (; k < end; ++k) {
            const TrendPoint& p = points[k];
            const double residual = p.value - trend(p.time_s);
            chi2 += p.weight * residual * residual;
            weight += p.weight;
            off += p.weight * residual;
        }
        chi2_of_means += off * off / weight;
    }
    Scatter scatter;
    const auto larger = [&](double sum, std::size_t count) {
        const double dof = static_cast<double>(count) - parameters;
        return dof > 0 && sum / dof > 1 + significant * std::sqrt(2 / dof) ? std::sqrt(sum / dof)
                                                                           : 1.0;
    };
    scatter.chi2_per_dof = chi2 / (static_cast<double>(points.size()) - parameters);
    scatter.enlargement = std::max(larger(chi2, points.size()), larger(chi2_of_means, groups));
    return scatter;
}

std::size_t windows_apart(std::int64_t length, std::int64_t hop) {
    return static_cast<std::size_t>(std::max<std::int64_t>((length + hop - 1) / hop, 1));
}

}  // namespace vybeg
