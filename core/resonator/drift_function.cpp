#include "core/resonator/drift_function.h"

#include "core/estimators/wave_state.h"
#include "core/numerics/phase.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

// m, c4, s4, c8, s8, and the two of the quadrature.
constexpr int terms = 7;
using Terms = Eigen::Matrix<double, terms, 1>;
using TermMatrix = Eigen::Matrix<double, terms, terms>;

constexpr double angle_needs_sd = 6;
// Least eigenvalue of the information in units of that of a constant drift: three starts 22.5
// degrees apart have 0.2, three starts at half of that 0.03.
constexpr double least_information = 0.02;
// Power of the quadrature against that of its noise at which its term is fitted along: below, the
// regressor is noise.
constexpr double quadrature_power = 4;
constexpr double point_reach = 5 * std::numbers::pi / 180;

// A window with an angle.
struct Place {
    double time_s = 0;
    double theta = 0;  // unwrapped along the run
    double sd_theta = 0;
    double p = 0;
    double q = 0;
    double sd_q = 0;
    double by_quadrature = 0;  // by so much the quadrature has turned it since its stretch began
};

std::optional<Place> place_of(const PhasorRun& run, std::size_t k) {
    const WaveState state = to_wave_state({run.c[k], run.d[k]});
    const double sd = run.sd[k];
    if (state.a_A - std::abs(state.a_B) < angle_needs_sd * sd) {
        return std::nullopt;
    }
    const double difference = state.a_A * state.a_A - state.a_B * state.a_B;
    const double sum = state.a_A * state.a_A + state.a_B * state.a_B;
    Place place;
    place.time_s = run.time_s[k];
    place.theta = state.two_theta_A / 2;
    place.sd_theta = 0.5 * sd * std::sqrt(sum) / difference;
    place.p = sum / difference;
    place.q = state.a_A * state.a_B / difference;
    place.sd_q = sd * state.a_A / difference;
    return place;
}

// Consecutive windows without a gap.
using Stretch = std::vector<Place>;

std::vector<Stretch> stretches_of(const PhasorRun& run) {
    std::vector<Stretch> stretches;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        std::optional<Place> place = place_of(run, k);
        if (!place) {
            continue;
        }
        const bool goes_on = !stretches.empty() &&
                             place->time_s - stretches.back().back().time_s < 1.5 * run.window_s;
        if (!goes_on) {
            stretches.emplace_back();
        } else {
            place->theta =
                nearest_branch(place->theta, stretches.back().back().theta, std::numbers::pi / 2);
        }
        stretches.back().push_back(*place);
    }
    return stretches;
}

Terms terms_at(const Place& place) {
    const double c4 = std::cos(4 * place.theta);
    const double s4 = std::sin(4 * place.theta);
    Terms value;
    value << 1, place.p * c4, place.p * s4, std::cos(8 * place.theta), std::sin(8 * place.theta),
        place.q * c4, place.q * s4;
    return value;
}

// The integrals of the terms from the first place of a stretch, by trapezoids.
std::vector<Terms> integrals(const Stretch& stretch) {
    std::vector<Terms> sums(stretch.size(), Terms::Zero());
    Terms last = terms_at(stretch.front());
    for (std::size_t k = 1; k < stretch.size(); ++k) {
        const Terms next = terms_at(stretch[k]);
        sums[k] = sums[k - 1] + 0.5 * (stretch[k].time_s - stretch[k - 1].time_s) * (last + next);
        last = next;
    }
    return sums;
}

// Normal equations of all stretches, their start angles eliminated.
struct Normal {
    TermMatrix information = TermMatrix::Zero();
    Terms moment = Terms::Zero();
    double square = 0;  // of theta about its means, in standard deviations
    double count = 0;
    double starts = 0;
    double q_power = 0;  // in that of its noise, summed

    void add(const Stretch& stretch) {
        const std::vector<Terms> sums = integrals(stretch);
        double weight = 0;
        double mean_theta = 0;
        Terms mean = Terms::Zero();
        for (std::size_t k = 0; k < stretch.size(); ++k) {
            const double w = 1 / (stretch[k].sd_theta * stretch[k].sd_theta);
            weight += w;
            mean_theta += w * (stretch[k].theta - stretch.front().theta);
            mean += w * sums[k];
        }
        mean_theta = mean_theta / weight + stretch.front().theta;
        mean /= weight;
        for (std::size_t k = 0; k < stretch.size(); ++k) {
            const double w = 1 / (stretch[k].sd_theta * stretch[k].sd_theta);
            const Terms row = sums[k] - mean;
            const double off = stretch[k].theta - mean_theta;
            information += w * row * row.transpose();
            moment += w * off * row;
            square += w * off * off;
            q_power += std::pow(stretch[k].q / stretch[k].sd_q, 2);
        }
        count += static_cast<double>(stretch.size());
        starts += 1;
    }
};

// The terms of an order, and those of the quadrature.
std::vector<int> chosen(int order, bool quadrature) {
    std::vector<int> list{0};
    for (int harmonic = 4; harmonic <= order; harmonic += 4) {
        list.push_back(harmonic / 2 - 1);
        list.push_back(harmonic / 2);
    }
    if (quadrature) {
        list.insert(list.end(), {5, 6});
    }
    return list;
}

// Fits the chosen terms into `found`; false where the angles cannot tell them apart.
// `fitted` gets the coefficients of all terms, 0 where they were not chosen.
bool fit(const Normal& normal, int order, bool quadrature, DriftFunction& found, Terms& fitted) {
    const std::vector<int> list = chosen(order, quadrature);
    const Eigen::MatrixXd information = normal.information(list, list);
    // All terms of the curve have amplitude one; only those of the quadrature have a size of their
    // own.
    Eigen::VectorXd scale = information.diagonal().cwiseSqrt().cwiseInverse();
    scale.head(1 + order / 2).setConstant(scale[0]);
    if (!scale.allFinite()) {
        return false;
    }
    const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
    const Eigen::Index kept = 1 + order / 2;
    // Of the curve alone: what the quadrature takes from it shows in the deviations.
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled.topLeftCorner(kept, kept),
                                                               Eigen::EigenvaluesOnly);
    if (eigen.eigenvalues()[0] < least_information) {
        return false;
    }
    const Eigen::VectorXd moment = normal.moment(list);
    const Eigen::LDLT<Eigen::MatrixXd> solver(scaled);
    const Eigen::VectorXd all = scale.asDiagonal() * solver.solve(scale.asDiagonal() * moment);
    const auto size = static_cast<Eigen::Index>(list.size());
    Eigen::MatrixXd covariance = scale.asDiagonal() *
                                 solver.solve(Eigen::MatrixXd::Identity(size, size)) *
                                 scale.asDiagonal();
    const double freedom = normal.count - normal.starts - static_cast<double>(size);
    const double chi2 = normal.square - all.dot(moment);
    found.order = order;
    found.chi2_per_freedom = freedom > 0 ? chi2 / freedom : 1;
    // What the model leaves counts as noise where it is more than the noise's own scatter.
    if (freedom > 0 && found.chi2_per_freedom > 1 + 3 * std::sqrt(2 / freedom)) {
        covariance *= found.chi2_per_freedom;
    }
    found.coefficients = all.head(kept);
    fitted(list) = all;
    found.covariance = covariance.topLeftCorner(kept, kept);
    return true;
}

// The straight line through the places [first, end) of a stretch, by weighted least squares, less
// what the quadrature turns them.
DriftPoint point_of(std::size_t run, const Stretch& stretch, std::size_t first, std::size_t end) {
    double weight = 0;
    double mean_t = 0;
    double mean_theta = 0;
    const double theta0 = stretch[first].theta;
    const double t0 = stretch[first].time_s;
    for (std::size_t k = first; k < end; ++k) {
        const double w = 1 / (stretch[k].sd_theta * stretch[k].sd_theta);
        weight += w;
        mean_t += w * (stretch[k].time_s - t0);
        mean_theta += w * (stretch[k].theta - theta0);
    }
    mean_t /= weight;
    mean_theta /= weight;
    double spread = 0;
    double moment = 0;
    for (std::size_t k = first; k < end; ++k) {
        const double w = 1 / (stretch[k].sd_theta * stretch[k].sd_theta);
        const double t = stretch[k].time_s - t0 - mean_t;
        spread += w * t * t;
        moment += w * t * (stretch[k].theta - theta0 - mean_theta - stretch[k].by_quadrature);
    }
    return {run, wrap(4 * (theta0 + mean_theta)) / 4, moment / spread, 1 / std::sqrt(spread)};
}

// Stretches are cut by time so that the angle moves by point_reach in each on the average.
void add_points(std::size_t run, const Stretch& stretch, std::vector<DriftPoint>& points) {
    const auto [low, high] = std::ranges::minmax_element(stretch, {}, &Place::theta);
    const double sweep = high->theta - low->theta;
    // A line needs three places, and its point is worth telling from eight on.
    const std::size_t most = stretch.size() / 8;
    const auto pieces = std::min(
        most, std::max<std::size_t>(
                  1, static_cast<std::size_t>(std::ceil(std::min(sweep / point_reach, 1e6)))));
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        points.push_back(point_of(run, stretch, piece * stretch.size() / pieces,
                                  (piece + 1) * stretch.size() / pieces));
    }
}

Eigen::VectorXd curve_terms(double theta, Eigen::Index count) {
    return terms_at({0, theta, 0, 1, 0, 0}).head(count);
}

}  // namespace

double DriftFunction::rate(double theta) const {
    return coefficients.dot(curve_terms(theta, coefficients.size()));
}

double DriftFunction::sd_rate(double theta) const {
    const Eigen::VectorXd at = curve_terms(theta, coefficients.size());
    return std::sqrt(at.dot(covariance * at));
}

DriftFunction drift_function(std::span<const PhasorRun> runs) {
    DriftFunction found;
    Normal normal;
    std::vector<std::pair<std::size_t, Stretch>> stretches;  // with their runs
    for (std::size_t run = 0; run < runs.size(); ++run) {
        for (Stretch& stretch : stretches_of(runs[run])) {
            if (stretch.size() > 2) {
                normal.add(stretch);
                stretches.emplace_back(run, std::move(stretch));
            }
        }
    }
    const bool quadrature = normal.q_power > quadrature_power * normal.count;
    Terms fitted = Terms::Zero();
    for (const int order : {8, 4}) {
        if (normal.count > 0 && fit(normal, order, quadrature, found, fitted)) {
            break;
        }
    }
    for (auto& [run, stretch] : stretches) {
        Stretch linear = stretch;
        for (Place& place : linear) {
            place.p = 1;
            place.q = 0;
        }
        const std::vector<Terms> with = integrals(stretch);
        const std::vector<Terms> without = integrals(linear);
        for (std::size_t k = 0; k < stretch.size(); ++k) {
            stretch[k].by_quadrature = fitted.dot(with[k] - without[k]);
        }
        add_points(run, stretch, found.points);
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
