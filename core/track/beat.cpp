#include "core/track/beat.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

constexpr std::size_t least_beat_windows = 10;
constexpr double least_periods = 1.25;
constexpr double most_periods = 100;
constexpr double steps_per_period = 6;        // of the search: frequencies 1/(6 span) apart
constexpr std::size_t searched_points = 512;  // more than four a period
constexpr std::size_t fitted_points = 16384;  // averaging flattens a sinusoid by 6e-5 at most
constexpr double significant_amplitude = 6;   // standard deviations
constexpr int most_iterations = 30;
constexpr double converged = 1e-6;  // change of the frequency in its deviations

// Frequency and damping in units of the span, value and amplitudes as they are.
enum Parameter { offset, slope, in_phase, quadrature, frequency, damping, parameter_count };
using Vector = Eigen::Vector<double, parameter_count>;
using Matrix = Eigen::Matrix<double, parameter_count, parameter_count>;

// Points with times in units of the span, from its middle on.
using Points = std::vector<TrendPoint>;

Points averaged(const Points& points, std::size_t most) {
    const std::size_t group = (points.size() + most - 1) / most;
    if (group == 1) {
        return points;
    }
    Points means;
    means.reserve(points.size() / group + 1);
    for (std::size_t first = 0; first < points.size(); first += group) {
        TrendPoint mean;
        for (std::size_t k = first; k < std::min(first + group, points.size()); ++k) {
            const TrendPoint& p = points[k];
            mean.weight += p.weight;
            mean.time_s += p.weight * p.time_s;
            mean.value += p.weight * p.value;
        }
        mean.time_s /= mean.weight;
        mean.value /= mean.weight;
        means.push_back(mean);
    }
    return means;
}

// Model and derivatives at a time.
double model(const Vector& x, double u, Vector& derivative) {
    const double turn = 2 * std::numbers::pi;
    const double decay = std::exp(-x[damping] * u);
    const double c = decay * std::cos(turn * x[frequency] * u);
    const double s = decay * std::sin(turn * x[frequency] * u);
    const double wave = x[in_phase] * c + x[quadrature] * s;
    derivative << 1, u, c, s, turn * u * (x[quadrature] * c - x[in_phase] * s), -u * wave;
    return x[offset] + x[slope] * u + wave;
}

struct Fit {
    Vector x = Vector::Zero();
    Matrix covariance = Matrix::Zero();
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
    Vector derivative;
    for (const TrendPoint& p : points) {
        model(fit.x, p.time_s, derivative);
        const auto basis = derivative.head<count>();
        normal.selfadjointView<Eigen::Lower>().rankUpdate(basis, p.weight);
        right += p.weight * p.value * basis;
        squares += p.weight * p.value * p.value;
    }
    const Eigen::Vector<double, count> found =
        normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    fit.x.head<count>() = found;
    fit.chi2 = squares - found.dot(right);
    return fit;
}

Fit search(const Points& points) {
    Fit best;
    for (double periods = least_periods; periods <= most_periods; periods += 1 / steps_per_period) {
        Fit fit = linear_fit(points, periods);
        if (fit.chi2 < best.chi2) {
            best = std::move(fit);
        }
    }
    return best;
}

// Gauss-Newton; a step that raises chi^2 is halved.
Fit refined(const Points& points, Fit fit) {
    const auto evaluate = [&](const Vector& x, Matrix& normal, Vector& right) {
        normal.setZero();
        right.setZero();
        double chi2 = 0;
        Vector derivative;
        for (const TrendPoint& p : points) {
            const double off = p.value - model(x, p.time_s, derivative);
            normal.selfadjointView<Eigen::Lower>().rankUpdate(derivative, p.weight);
            right += p.weight * off * derivative;
            chi2 += p.weight * off * off;
        }
        return chi2;
    };
    Matrix normal;
    Vector right;
    fit.chi2 = evaluate(fit.x, normal, right);
    for (int round = 0; round < most_iterations; ++round) {
        const auto solver = normal.selfadjointView<Eigen::Lower>().ldlt();
        Vector step = solver.solve(right);
        fit.covariance = solver.solve(Matrix::Identity());
        Vector next = fit.x + step;
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
    beat.centre_s = 0.5 * (points.front().time_s + points.back().time_s);
    const double span = points.back().time_s - points.front().time_s;
    // About the first value: frequencies are large against what they change by.
    const double first = points.front().value;
    for (TrendPoint& p : points) {
        p.time_s = (p.time_s - beat.centre_s) / span;
        p.value -= first;
    }
    points = averaged(points, fitted_points);
    const Fit fit = refined(points, search(averaged(points, searched_points)));
    const Vector& x = fit.x;
    Vector derivative;
    const Scatter scatter =
        scatter_about(points, parameter_count, [&](double u) { return model(x, u, derivative); });
    beat.chi2_per_dof = scatter.chi2_per_dof;
    const auto sd = [&](const Vector& direction) {
        return std::sqrt(direction.dot(fit.covariance * direction));
    };
    beat.value = first + x[offset];
    beat.slope_per_s = x[slope] / span;
    beat.in_phase = x[in_phase];
    beat.quadrature = x[quadrature];
    beat.frequency_hz = x[frequency] / span;
    beat.sd_frequency_hz = sd(Vector::Unit(frequency)) / span;
    beat.damping_per_s = x[damping] / span;
    beat.sd_damping_per_s = sd(Vector::Unit(damping)) / span;
    beat.amplitude = std::hypot(x[in_phase], x[quadrature]);
    beat.sd_amplitude =
        sd((x[in_phase] * Vector::Unit(in_phase) + x[quadrature] * Vector::Unit(quadrature)) /
           beat.amplitude);
    const bool found = x[frequency] >= least_periods && x[frequency] <= most_periods + 1 &&
                       scatter.enlargement == 1 &&
                       beat.amplitude > significant_amplitude * beat.sd_amplitude;
    return found ? std::optional(beat) : std::nullopt;
}

}  // namespace vybeg
