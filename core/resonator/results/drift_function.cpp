#include "core/resonator/results/drift_function.h"

#include "core/estimators/wave/wave_state.h"
#include "core/numerics/harmonic_terms.h"
#include "core/numerics/phase.h"
#include "core/numerics/statistics.h"

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

// theta_A less the fitted one: measured, then of the motion with each tolerated error.
using Residuals = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1,
                                1 + static_cast<int>(channel_errors.size())>;

// Window with an angle.
struct AngleWindow {
    double time_s = 0;
    double theta = 0;  // of the fitted wave, unwrapped along the run
    Residuals residual;
    double sd = 0;  // of the measured theta_A
};

// Consecutive windows without a gap.
using Segment = std::vector<AngleWindow>;

double half_turn(double two_theta, double fitted) {
    return std::remainder(two_theta - fitted, std::numbers::pi) / 2;
}

// All angles are those of the pick-offs, so that the errors of the channels that the fit knows
// cancel in the difference.
std::vector<Segment> segments_of(const PhasorRun& run, const ResonatorFit& fit, std::size_t index) {
    const std::vector<Phasors> seen = predicted_phasors(fit.motion, index, run.time_s);
    const std::vector<Phasors> waves = predicted_waves(fit.motion, index, run.time_s);
    std::vector<std::vector<Phasors>> tolerated;
    for (const DriftTerms::Tolerated& each : fit.drift_terms.tolerated) {
        tolerated.push_back(predicted_phasors(each.motion, index, run.time_s));
    }
    std::vector<Segment> segments;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const WaveState fitted = to_wave_state(seen[k]);
        if (fitted.a_A - std::abs(fitted.a_B) < angle_needs_sd * run.sd[k]) {
            continue;
        }
        const WaveState measured = to_wave_state({run.c[k], run.d[k]});
        const double sum = fitted.a_A * fitted.a_A + fitted.a_B * fitted.a_B;
        const double difference = fitted.a_A * fitted.a_A - fitted.a_B * fitted.a_B;
        AngleWindow place{.time_s = run.time_s[k],
                          .theta = to_wave_state(waves[k]).two_theta_A / 2,
                          .residual = Residuals(1 + std::ssize(tolerated)),
                          .sd = 0.5 * run.sd[k] * std::sqrt(sum) / difference};
        place.residual[0] = half_turn(measured.two_theta_A, fitted.two_theta_A);
        for (std::size_t error = 0; error < tolerated.size(); ++error) {
            place.residual[static_cast<Eigen::Index>(error) + 1] =
                half_turn(to_wave_state(tolerated[error][k]).two_theta_A, fitted.two_theta_A);
        }
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
    Eigen::Matrix<double, drift_terms, Eigen::Dynamic> moment;  // a column for each residual
    double square = 0;  // of the measured one about its means, in standard deviations
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
        Residuals mean_residual = Residuals::Zero(segment.front().residual.size());
        Terms mean = Terms::Zero();
        for (std::size_t k = 0; k < segment.size(); ++k) {
            const double w = 1 / (segment[k].sd * segment[k].sd);
            weight += w;
            mean_residual += w * segment[k].residual;
            mean += w * sums[k];
        }
        mean_residual /= weight;
        mean /= weight;
        if (moment.cols() == 0) {
            moment.setZero(drift_terms, mean_residual.size());
        }
        for (std::size_t k = 0; k < segment.size(); ++k) {
            const double w = 1 / (segment[k].sd * segment[k].sd);
            const Terms row = sums[k] - mean;
            const Residuals off = segment[k].residual - mean_residual;
            information += w * row * row.transpose();
            moment += w * row * off;
            square += w * off[0] * off[0];
        }
        freedom += static_cast<double>(segment.size()) - 1;
    }
};

// m, c4, s4 of r, g cos 4theta_tau, g sin 4theta_tau.
const Eigen::Matrix3d of_terms{{-0.5, 0, 0}, {0, 0, -0.25}, {0, 0.25, 0}};

// m, c4, s4 of the fit.
void take_fourth(const DriftTerms& terms, DriftFunction& found) {
    found.order = 4;
    found.coefficients = of_terms * terms.value;
    found.covariance = of_terms * terms.covariance * of_terms.transpose();
    found.tolerances = of_terms * terms.spread * of_terms.transpose();
    for (const DriftTerms::Tolerated& each : terms.tolerated) {
        const Eigen::Vector3d moved = of_terms * each.moved;
        found.tolerances += moved * moved.transpose();
    }
}

// Adds the information of the residual angles on all five terms, if they separate them.
void add_eighth(const Normal& normal, const DriftTerms& terms, DriftFunction& found) {
    if (!separates_terms(normal.information)) {
        return;
    }
    const TermMatrix all = normal.information.inverse();
    const Eigen::Matrix3d three = normal.information.topLeftCorner<3, 3>().inverse();
    // Excess of the fit's covariance, which includes coloured noise, over that of these angles
    // alone.
    const double wider =
        (found.covariance.diagonal().array() / three.diagonal().array()).maxCoeff();
    Eigen::MatrixXd change = all * normal.moment;
    change.col(0).head<3>() += found.coefficients;
    found.order = 8;
    found.coefficients = change.col(0);
    found.covariance = std::max(1.0, wider) * all;
    found.tolerances = Eigen::MatrixXd::Zero(drift_terms, drift_terms);
    found.tolerances.topLeftCorner<3, 3>() = of_terms * terms.spread * of_terms.transpose();
    // The residual has what the fit does not follow of an error.
    for (std::size_t k = 0; k < terms.tolerated.size(); ++k) {
        Terms off = change.col(static_cast<Eigen::Index>(k) + 1);
        off.head<3>() += of_terms * terms.tolerated[k].moved;
        found.tolerances += off * off.transpose();
    }
}

// Point of the places [first, end) of a segment: slope of their residual plus the drift of a linear
// wave at their mean angle.
DriftPoint point_of(std::size_t run, const Segment& segment, std::size_t first, std::size_t end,
                    const Eigen::Matrix2cd& m) {
    const auto weight_of = [&](std::size_t k) { return 1 / (segment[k].sd * segment[k].sd); };
    const LineFit line = fit_line(end - first, [&](std::size_t k) {
        const AngleWindow& at = segment[first + k];
        return LinePoint{at.time_s, at.residual[0], weight_of(first + k)};
    });
    double mean_theta = 0;
    for (std::size_t k = first; k < end; ++k) {
        mean_theta += weight_of(k) * (segment[k].theta + segment[k].residual[0]);
    }
    mean_theta /= line.weight;
    return {run, wrap(4 * mean_theta) / 4, drift_of_dynamics(m, mean_theta) + line.slope,
            1 / std::sqrt(line.spread)};
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
    const Eigen::Matrix2cd m = SlowDynamics(fit.motion.shared).matrix();
    for (std::size_t run = 0; run < runs.size() && !job.cancelled(); ++run) {
        if (fit.left_out == run) {
            continue;
        }
        for (const Segment& segment : segments_of(runs[run], fit, run)) {
            normal.add(segment);
            add_points(run, segment, m, found.points);
        }
    }
    found.chi2_per_freedom = normal.freedom > 0 ? normal.square / normal.freedom : 1;
    if (fit.drift_terms.given && normal.freedom > 0) {
        take_fourth(fit.drift_terms, found);
        add_eighth(normal, fit.drift_terms, found);
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
