#include "core/resonator/results/drift_function.h"

#include "core/estimators/wave/wave_state.h"
#include "core/numerics/harmonic_terms.h"
#include "core/numerics/phase.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace vybeg {
namespace {

// m, c4, s4, c8, s8.
constexpr std::array harmonics{4, 8};
constexpr int drift_terms = 5;
using Terms = Eigen::Matrix<double, drift_terms, 1>;
using TermMatrix = Eigen::Matrix<double, drift_terms, drift_terms>;

constexpr double angle_needs_sd = 6;
constexpr double point_reach = 5 * std::numbers::pi / 180;
// Least number of windows of the straight line of a point.
constexpr std::size_t least_point_windows = 8;

// Window with an angle.
struct AngleWindow {
    double time_s = 0;
    double theta = 0;     // of the fitted wave, unwrapped along the run
    double residual = 0;  // measured less fitted theta_A
    double sd = 0;        // of the measured theta_A
};

// Consecutive windows without a gap.
using Segment = std::vector<AngleWindow>;

// Measured and fitted angles are those of the pick-offs, so that the errors of the channels cancel
// in the difference.
std::vector<Segment> segments_of(const PhasorRun& run, const FittedMotion& motion,
                                 std::size_t index) {
    const std::vector<Phasors> seen = predicted_phasors(motion, index, run.time_s);
    const std::vector<Phasors> waves = predicted_waves(motion, index, run.time_s);
    std::vector<Segment> segments;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const WaveState fitted = to_wave_state(seen[k]);
        if (fitted.a_A - std::abs(fitted.a_B) < angle_needs_sd * run.sd[k]) {
            continue;
        }
        const WaveState measured = to_wave_state({run.c[k], run.d[k]});
        const double sum = fitted.a_A * fitted.a_A + fitted.a_B * fitted.a_B;
        const double difference = fitted.a_A * fitted.a_A - fitted.a_B * fitted.a_B;
        AngleWindow place{
            .time_s = run.time_s[k],
            .theta = to_wave_state(waves[k]).two_theta_A / 2,
            .residual =
                std::remainder(measured.two_theta_A - fitted.two_theta_A, std::numbers::pi) / 2,
            .sd = 0.5 * run.sd[k] * std::sqrt(sum) / difference};
        const bool goes_on =
            !segments.empty() && place.time_s - segments.back().back().time_s < 1.5 * run.window_s;
        if (goes_on) {
            place.theta =
                nearest_branch(place.theta, segments.back().back().theta, std::numbers::pi / 2);
        } else {
            segments.emplace_back();
        }
        segments.back().push_back(place);
    }
    std::erase_if(segments, [](const Segment& segment) { return segment.size() < 3; });
    return segments;
}

Terms terms_at(double theta) {
    return harmonic_terms<Terms>(harmonics, theta);
}

// Normal equations of all segments, their start angles eliminated.
struct Normal {
    TermMatrix information = TermMatrix::Zero();
    Terms moment = Terms::Zero();
    double square = 0;  // of the residual about its means, in standard deviations
    double freedom = 0;

    void add(const Segment& segment) {
        std::vector<double> time_s;
        std::vector<double> theta;
        for (const AngleWindow& place : segment) {
            time_s.push_back(place.time_s);
            theta.push_back(place.theta);
        }
        const std::vector<Terms> sums = term_integrals<Terms>(harmonics, time_s, theta);
        double weight = 0;
        double mean_residual = 0;
        Terms mean = Terms::Zero();
        for (std::size_t k = 0; k < segment.size(); ++k) {
            const double w = 1 / (segment[k].sd * segment[k].sd);
            weight += w;
            mean_residual += w * segment[k].residual;
            mean += w * sums[k];
        }
        mean_residual /= weight;
        mean /= weight;
        for (std::size_t k = 0; k < segment.size(); ++k) {
            const double w = 1 / (segment[k].sd * segment[k].sd);
            const Terms row = sums[k] - mean;
            const double off = segment[k].residual - mean_residual;
            information += w * row * row.transpose();
            moment += w * off * row;
            square += w * off * off;
        }
        freedom += static_cast<double>(segment.size()) - 1;
    }
};

// m, c4, s4 of the fit.
void take_fourth(const DriftTerms& terms_of_fit, DriftFunction& found) {
    Eigen::Matrix3d of_terms;
    of_terms << -0.5, 0, 0, 0, 0, -0.25, 0, 0.25, 0;
    const Eigen::Map<const Eigen::Vector3d> value(terms_of_fit.value.data());
    using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const Eigen::Map<const RowMajor3> covariance(terms_of_fit.covariance.data());
    const Eigen::Map<const RowMajor3> tolerances(terms_of_fit.tolerances.data());
    found.order = 4;
    found.coefficients = of_terms * value;
    found.covariance = of_terms * covariance * of_terms.transpose();
    found.tolerances = of_terms * tolerances * of_terms.transpose();
}

// Adds the information of the residual angles on all five terms, if they separate them.
void add_eighth(const Normal& normal, DriftFunction& found) {
    if (!separates_terms(normal.information)) {
        return;
    }
    const TermMatrix all = normal.information.inverse();
    const Eigen::Matrix3d three = normal.information.topLeftCorner<3, 3>().inverse();
    // Excess of the fit's covariance, which includes coloured noise, over that of these angles
    // alone.
    const double wider =
        (found.covariance.diagonal().array() / three.diagonal().array()).maxCoeff();
    const Terms change = all * normal.moment;
    Eigen::VectorXd whole = change;
    whole.head<3>() += found.coefficients;
    found.order = 8;
    found.coefficients = whole;
    found.covariance = std::max(1.0, wider) * all;
    // Errors of the channels leave the fourth harmonic as the fit has it.
    const Eigen::MatrixXd of_fit = found.tolerances;
    found.tolerances = Eigen::MatrixXd::Zero(drift_terms, drift_terms);
    found.tolerances.topLeftCorner<3, 3>() = of_fit;
}

// Point of the places [first, end) of a segment: slope of their residual plus the drift of a linear
// wave at their mean angle.
DriftPoint point_of(std::size_t run, const Segment& segment, std::size_t first, std::size_t end,
                    const Eigen::Matrix2cd& m) {
    double weight = 0;
    double mean_t = 0;
    double mean_theta = 0;
    double mean = 0;
    for (std::size_t k = first; k < end; ++k) {
        const double w = 1 / (segment[k].sd * segment[k].sd);
        weight += w;
        mean_t += w * segment[k].time_s;
        mean_theta += w * (segment[k].theta + segment[k].residual);
        mean += w * segment[k].residual;
    }
    mean_t /= weight;
    mean_theta /= weight;
    mean /= weight;
    double spread = 0;
    double moment = 0;
    for (std::size_t k = first; k < end; ++k) {
        const double w = 1 / (segment[k].sd * segment[k].sd);
        const double t = segment[k].time_s - mean_t;
        spread += w * t * t;
        moment += w * t * (segment[k].residual - mean);
    }
    return {run, wrap(4 * mean_theta) / 4, drift_of_dynamics(m, mean_theta) + moment / spread,
            1 / std::sqrt(spread)};
}

// Segments are cut by time so that the angle moves by point_reach in each on the average.
void add_points(std::size_t run, const Segment& segment, const Eigen::Matrix2cd& m,
                std::vector<DriftPoint>& points) {
    const auto [low, high] = std::ranges::minmax_element(segment, {}, &AngleWindow::theta);
    const double sweep = high->theta - low->theta;
    const std::size_t most = segment.size() / least_point_windows;
    const auto pieces = std::min(
        most, std::max<std::size_t>(
                  1, static_cast<std::size_t>(std::ceil(std::min(sweep / point_reach, 1e6)))));
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        points.push_back(point_of(run, segment, piece * segment.size() / pieces,
                                  (piece + 1) * segment.size() / pieces, m));
    }
}

}  // namespace

Estimate DriftFunction::coefficient(Eigen::Index k) const {
    Estimate out;
    out.value = coefficients[k];
    out.sd = std::sqrt(covariance(k, k));
    if (tolerances(k, k) > 0) {
        out.u = std::sqrt(covariance(k, k) + tolerances(k, k));
    }
    return out;
}

double DriftFunction::rate(double theta) const {
    return coefficients.dot(terms_at(theta).head(coefficients.size()));
}

double DriftFunction::sd_rate(double theta) const {
    const Eigen::VectorXd at = terms_at(theta).head(coefficients.size());
    return std::sqrt(at.dot(covariance * at));
}

double DriftFunction::u_rate(double theta) const {
    const Eigen::VectorXd at = terms_at(theta).head(coefficients.size());
    return std::sqrt(at.dot((covariance + tolerances) * at));
}

DriftFunction drift_function(std::span<const PhasorRun> runs, const ResonatorFit& fit,
                             const JobControl& job) {
    DriftFunction found;
    Normal normal;
    const Eigen::Matrix2cd m = SlowDynamics(fit.motion.rates()).matrix();
    for (std::size_t run = 0; run < runs.size() && !job.cancelled(); ++run) {
        if (fit.left_out == run) {
            continue;
        }
        for (const Segment& segment : segments_of(runs[run], fit.motion, run)) {
            normal.add(segment);
            add_points(run, segment, m, found.points);
        }
    }
    found.chi2_per_freedom = normal.freedom > 0 ? normal.square / normal.freedom : 1;
    if (fit.drift_terms.given && normal.freedom > 0) {
        take_fourth(fit.drift_terms, found);
        add_eighth(normal, found);
    } else {
        // Split and axes, by which the quadrature turns the wave, are unknown too: a point would be
        // off by many of its deviations.
        found.points.clear();
    }
    return found;
}

double drift_of_dynamics(const Eigen::Matrix2cd& m, double theta) {
    constexpr std::complex<double> i{0, 1};
    const Eigen::Vector2cd z{std::cos(2 * theta), std::sin(2 * theta)};
    const Eigen::Vector2cd moved = m * z;
    // 2 theta_A = (arg u+ - arg u-)/2, u+- = c +- i d.
    const std::complex<double> plus = (moved[0] + i * moved[1]) / (z[0] + i * z[1]);
    const std::complex<double> minus = (moved[0] - i * moved[1]) / (z[0] - i * z[1]);
    return (plus.imag() - minus.imag()) / 4;
}

}  // namespace vybeg
