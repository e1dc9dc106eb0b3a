#include "core/track/trend.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

constexpr double significant = 3;  // standard deviations of chi^2 per degree of freedom
constexpr std::size_t most_groups = 24;
constexpr std::size_t least_in_group = 4;  // points

constexpr std::size_t least_trend_windows = 3;
constexpr double decays_from = 2;  // standard deviations of the slope

}  // namespace

std::vector<TrendPoint> trend_points(const Track& track, SlowVariable variable, double from_s,
                                     double to_s, std::size_t apart, TrendOf of) {
    if (track.sds(variable).empty()) {
        return {};
    }
    constexpr double turn = 2 * std::numbers::pi;
    const bool wrapped = variable == SlowVariable::delta_phi_CD || variable == SlowVariable::alpha;
    const auto times = track.time_s();
    const auto values = track.values(variable);
    const auto sds = track.sds(variable);
    const auto first =
        static_cast<std::size_t>(std::ranges::lower_bound(times, from_s) - times.begin());
    std::vector<TrendPoint> found;
    for (std::size_t k = first; k < times.size() && times[k] <= to_s;) {
        double value = values[k];
        double sd = sds[k];
        if (of == TrendOf::logarithm) {
            sd /= value;
            value = std::log(value);
        }
        if (!is_sound_window(track.flags()[k]) || !std::isfinite(value) || !(sd > 0)) {
            ++k;
            continue;
        }
        if (wrapped && !found.empty()) {
            value -= turn * std::round((value - found.back().value) / turn);
        }
        // Each window with its own deviation: that of a short one rests on a hundred degrees of
        // freedom, too, so that weights do not favour windows whose deviations are too small by
        // chance.
        found.push_back({times[k], value, 1 / (sd * sd)});
        k += apart;
    }
    return found;
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

double PolynomialTrend::at(double time_s) const {
    double value = 0;
    for (std::size_t k = coefficient.size(); k-- > 0;) {
        value = value * (time_s - centre_s) + coefficient[k];
    }
    return value;
}

std::optional<PolynomialTrend> polynomial_trend(const Track& track, SlowVariable variable,
                                                double from_s, double to_s, std::size_t apart,
                                                int degree) {
    constexpr int most = most_trend_degree + 1;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;
    const std::vector<TrendPoint> points = trend_points(track, variable, from_s, to_s, apart);
    const int count = degree + 1;
    if (points.size() < static_cast<std::size_t>(count) + 1) {
        return std::nullopt;
    }
    PolynomialTrend trend;
    trend.windows = points.size();
    trend.centre_s = (points.front().time_s + points.back().time_s) / 2;
    // Times from -1 to 1, where the powers up to the third are far from parallel, and values from
    // the first one on: they are large against what they change by.
    const double half_s = (points.back().time_s - points.front().time_s) / 2;
    const double first = points.front().value;
    Matrix normal = Matrix::Zero(count, count);
    Vector right = Vector::Zero(count);
    Vector powers(count);
    for (const TrendPoint& point : points) {
        const double u = (point.time_s - trend.centre_s) / half_s;
        powers[0] = 1;
        for (int k = 1; k < count; ++k) {
            powers[k] = powers[k - 1] * u;
        }
        normal.noalias() += point.weight * powers * powers.transpose();
        right += point.weight * (point.value - first) * powers;
    }
    const Eigen::LDLT<Matrix> factors(normal);
    const Vector solution = factors.solve(right);
    const Matrix covariance = factors.solve(Matrix::Identity(count, count));
    for (int k = 0; k < count; ++k) {
        const double scale = std::pow(half_s, -k);
        trend.coefficient.push_back(solution[k] * scale + (k == 0 ? first : 0));
        trend.sd.push_back(std::sqrt(covariance(k, k)) * scale);
    }
    const Scatter scatter =
        scatter_about(points, count, [&trend](double time_s) { return trend.at(time_s); });
    trend.chi2_per_dof = scatter.chi2_per_dof;
    trend.enlargement = scatter.enlargement;
    for (double& sd : trend.sd) {
        sd *= trend.enlargement;
    }
    return trend;
}

}  // namespace vybeg
