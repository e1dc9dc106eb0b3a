#include "core/track/trend.h"

#include "core/numerics/phase.h"
#include "core/numerics/statistics.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr double significant = 3;  // standard deviations of chi^2 per degree of freedom
constexpr std::size_t most_groups = 24;
constexpr std::size_t least_in_group = 4;  // points

constexpr std::size_t least_trend_windows = 3;
constexpr double decays_from = 2;  // standard deviations of the slope

// Values of a slow variable (y, stored units or their logarithm) over time (x, s); weight: 1/sd^2.
using Points = std::vector<LinePoint>;

// The windows that count (trend.h).
Points trend_points(const Track& track, SlowVariable variable, double from_s, double to_s,
                    std::size_t apart, TrendOf of = TrendOf::value) {
    if (track.sds(variable).empty()) {
        return {};
    }
    const bool wrapped = variable == SlowVariable::delta_phi_CD || variable == SlowVariable::alpha;
    const auto times = track.time_s();
    const auto values = track.values(variable);
    const auto sds = track.sds(variable);
    const auto first =
        static_cast<std::size_t>(std::ranges::lower_bound(times, from_s) - times.begin());
    Points found;
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
            value = nearest_branch(value, found.back().y, 2 * std::numbers::pi);
        }
        // Each window with its own deviation: that of a short one rests on a hundred degrees of
        // freedom, too, so that weights do not favour windows whose deviations are too small by
        // chance.
        found.push_back({times[k], value, 1 / (sd * sd)});
        k += apart;
    }
    return found;
}

// How the points lie about a trend, in their standard deviations.
struct Scatter {
    double chi2_per_dof = 0;
    double enlargement = 1;
};

Scatter scatter_about(const Points& points, int parameters,
                      const std::function<double(double)>& trend) {
    const std::size_t groups = std::min(most_groups, points.size() / least_in_group);
    double chi2 = 0;
    double chi2_of_means = 0;
    for (std::size_t group = 0, k = 0; group < std::max<std::size_t>(groups, 1); ++group) {
        const std::size_t end = groups == 0 ? points.size() : (group + 1) * points.size() / groups;
        double weight = 0;
        double off = 0;
        for (; k < end; ++k) {
            const LinePoint& p = points[k];
            const double residual = p.y - trend(p.x);
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

// Of a beat, whose points have times in units of the span, from its middle on.
constexpr std::size_t least_beat_windows = 10;
constexpr double most_periods = 100;
constexpr double steps_per_period = 6;        // of the search: frequencies 1/(6 span) apart
constexpr std::size_t searched_points = 512;  // more than four a period
constexpr std::size_t fitted_points = 16384;  // averaging flattens a sinusoid by 6e-5 at most
constexpr double significant_amplitude = 6;   // standard deviations
constexpr int most_iterations = 30;
constexpr double converged = 1e-6;  // change of the frequency in its deviations

// Of a beat: frequency and damping in units of the span, value and amplitudes as they are.
enum Parameter { offset, slope, in_phase, quadrature, frequency, damping, parameter_count };
using BeatVector = Eigen::Vector<double, parameter_count>;
using BeatMatrix = Eigen::Matrix<double, parameter_count, parameter_count>;

Points averaged(const Points& points, std::size_t most) {
    const std::size_t group = (points.size() + most - 1) / most;
    if (group == 1) {
        return points;
    }
    Points means;
    means.reserve(points.size() / group + 1);
    for (std::size_t first = 0; first < points.size(); first += group) {
        LinePoint mean{0, 0, 0};
        for (std::size_t k = first; k < std::min(first + group, points.size()); ++k) {
            const LinePoint& p = points[k];
            mean.weight += p.weight;
            mean.x += p.weight * p.x;
            mean.y += p.weight * p.y;
        }
        mean.x /= mean.weight;
        mean.y /= mean.weight;
        means.push_back(mean);
    }
    return means;
}

// Model and derivatives at a time.
double model(const BeatVector& x, double u, BeatVector& derivative) {
    const double turn = 2 * std::numbers::pi;
    const double decay = std::exp(-x[damping] * u);
    const double c = decay * std::cos(turn * x[frequency] * u);
    const double s = decay * std::sin(turn * x[frequency] * u);
    const double wave = x[in_phase] * c + x[quadrature] * s;
    derivative << 1, u, c, s, turn * u * (x[quadrature] * c - x[in_phase] * s), -u * wave;
    return x[offset] + x[slope] * u + wave;
}

struct Fit {
    BeatVector x = BeatVector::Zero();
    BeatMatrix covariance = BeatMatrix::Zero();
    double chi2 = std::numeric_limits<double>::infinity();
};

// Line and sinusoid of one frequency: linear least squares.
Fit linear_fit(const Points& points, double periods) {
    constexpr int count = frequency;  // parameters before it
    Eigen::Matrix<double, count, count> normal = Eigen::Matrix<double, count, count>::Zero();
    Eigen::Vector<double, count> right = Eigen::Vector<double, count>::Zero();
    Fit fit;
    fit.x[frequency] = periods;
    double squares = 0;
    BeatVector derivative;
    for (const LinePoint& p : points) {
        model(fit.x, p.x, derivative);
        const auto basis = derivative.head<count>();
        normal.selfadjointView<Eigen::Lower>().rankUpdate(basis, p.weight);
        right += p.weight * p.y * basis;
        squares += p.weight * p.y * p.y;
    }
    const Eigen::Vector<double, count> found =
        normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    fit.x.head<count>() = found;
    fit.chi2 = squares - found.dot(right);
    return fit;
}

Fit search(const Points& points) {
    Fit best;
    for (double periods = least_beat_periods; periods <= most_periods;
         periods += 1 / steps_per_period) {
        Fit fit = linear_fit(points, periods);
        if (fit.chi2 < best.chi2) {
            best = std::move(fit);
        }
    }
    return best;
}

// Gauss-Newton; a step that raises chi^2 is halved.
Fit refined(const Points& points, Fit fit) {
    const auto evaluate = [&](const BeatVector& x, BeatMatrix& normal, BeatVector& right) {
        normal.setZero();
        right.setZero();
        double chi2 = 0;
        BeatVector derivative;
        for (const LinePoint& p : points) {
            const double off = p.y - model(x, p.x, derivative);
            normal.selfadjointView<Eigen::Lower>().rankUpdate(derivative, p.weight);
            right += p.weight * off * derivative;
            chi2 += p.weight * off * off;
        }
        return chi2;
    };
    BeatMatrix normal;
    BeatVector right;
    fit.chi2 = evaluate(fit.x, normal, right);
    for (int round = 0; round < most_iterations; ++round) {
        const auto solver = normal.selfadjointView<Eigen::Lower>().ldlt();
        BeatVector step = solver.solve(right);
        fit.covariance = solver.solve(BeatMatrix::Identity());
        BeatVector next = fit.x + step;
        double chi2 = evaluate(next, normal, right);
        for (int halved = 0; halved < 20 && !(chi2 <= fit.chi2); ++halved) {
            step *= 0.5;
            next = fit.x + step;
            chi2 = evaluate(next, normal, right);
        }
        if (!(chi2 <= fit.chi2)) {
            break;  // at the bottom, to the last digit
        }
        fit.x = next;
        fit.chi2 = chi2;
        if (step[frequency] * step[frequency] <
            converged * converged * fit.covariance(frequency, frequency)) {
            break;
        }
    }
    return fit;
}

}  // namespace

std::size_t windows_apart(std::int64_t length, std::int64_t hop) {
    return static_cast<std::size_t>(std::max<std::int64_t>((length + hop - 1) / hop, 1));
}

std::optional<Trend> line_trend(const Track& track, SlowVariable variable, double from_s,
                                double to_s, std::size_t apart, TrendOf of) {
    const Points found = trend_points(track, variable, from_s, to_s, apart, of);
    if (found.size() < least_trend_windows) {
        return std::nullopt;
    }
    Trend trend;
    trend.windows = found.size();
    // About the first point: times and frequencies are large against what they change by.
    const LineFit line = fit_line(found.size(), [&found](std::size_t k) {
        const LinePoint& p = found[k];
        return LinePoint{p.x - found[0].x, p.y - found[0].y, p.weight};
    });
    trend.centre_s = found[0].x + line.mean_x;
    trend.value = found[0].y + line.mean_y;
    trend.slope_per_s = line.slope;
    const Scatter scatter =
        scatter_about(found, 2, [&trend](double time_s) { return trend.at(time_s); });
    trend.chi2_per_dof = scatter.chi2_per_dof;
    trend.enlargement = scatter.enlargement;
    trend.sd_value = trend.enlargement / std::sqrt(line.weight);
    trend.sd_slope_per_s = trend.enlargement / std::sqrt(line.spread);
    return trend;
}

std::optional<DecayTime> decay_time(const Trend& of_logarithm) {
    const double rate = -of_logarithm.slope_per_s;
    if (!(rate > decays_from * of_logarithm.sd_slope_per_s)) {
        return std::nullopt;
    }
    return DecayTime{1 / rate, of_logarithm.sd_slope_per_s / (rate * rate)};
}

double Beat::at(double time_s) const {
    const double u = time_s - centre_s;
    const double angle = 2 * std::numbers::pi * frequency_hz * u;
    return value + slope_per_s * u +
           std::exp(-damping_per_s * u) *
               (in_phase * std::cos(angle) + quadrature * std::sin(angle));
}

std::optional<Beat> find_beat(const Track& track, SlowVariable variable, double from_s, double to_s,
                              std::size_t apart) {
    Points points = trend_points(track, variable, from_s, to_s, apart);
    if (points.size() < least_beat_windows) {
        return std::nullopt;
    }
    Beat beat;
    beat.windows = points.size();
    beat.centre_s = 0.5 * (points.front().x + points.back().x);
    const double span = points.back().x - points.front().x;
    // About the first value: frequencies are large against what they change by.
    const double first = points.front().y;
    for (LinePoint& p : points) {
        p.x = (p.x - beat.centre_s) / span;
        p.y -= first;
    }
    points = averaged(points, fitted_points);
    const Fit fit = refined(points, search(averaged(points, searched_points)));
    const BeatVector& x = fit.x;
    BeatVector derivative;
    const Scatter scatter =
        scatter_about(points, parameter_count, [&](double u) { return model(x, u, derivative); });
    beat.chi2_per_dof = scatter.chi2_per_dof;
    const auto sd = [&](const BeatVector& direction) {
        return std::sqrt(direction.dot(fit.covariance * direction));
    };
    beat.value = first + x[offset];
    beat.slope_per_s = x[slope] / span;
    beat.in_phase = x[in_phase];
    beat.quadrature = x[quadrature];
    beat.frequency_hz = x[frequency] / span;
    beat.sd_frequency_hz = sd(BeatVector::Unit(frequency)) / span;
    beat.damping_per_s = x[damping] / span;
    beat.sd_damping_per_s = sd(BeatVector::Unit(damping)) / span;
    beat.amplitude = std::hypot(x[in_phase], x[quadrature]);
    beat.sd_amplitude = sd(
        (x[in_phase] * BeatVector::Unit(in_phase) + x[quadrature] * BeatVector::Unit(quadrature)) /
        beat.amplitude);
    const bool found = x[frequency] >= least_beat_periods && x[frequency] <= most_periods + 1 &&
                       scatter.enlargement == 1 &&
                       beat.amplitude > significant_amplitude * beat.sd_amplitude;
    return found ? std::optional(beat) : std::nullopt;
}

}  // namespace vybeg
