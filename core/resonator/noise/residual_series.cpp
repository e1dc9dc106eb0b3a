#include "core/resonator/noise/residual_series.h"

#include "core/numerics/statistics.h"

#include <cmath>
#include <complex>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Vector2cd;

constexpr Complex i{0, 1};

// Amplitude in deviations below which the linear part replaces the logarithm of the phasor.
constexpr double clear_amplitude = 10;

// Correlation of points that are sums of `merge` windows over their root.
Eigen::MatrixXd merged_correlation(const std::vector<double>& correlation, std::size_t merge,
                                   Eigen::Index points) {
    if (correlation.empty()) {
        return {};
    }
    const auto n = static_cast<Eigen::Index>(merge);
    Eigen::MatrixXd merged = Eigen::MatrixXd::Zero(points, points);
    for (Eigen::Index lag = 0; lag < points; ++lag) {
        double sum = 0;
        for (Eigen::Index difference = 1 - n; difference < n; ++difference) {
            const auto at = static_cast<std::size_t>(std::abs(lag * n + difference));
            sum += at < correlation.size()
                       ? static_cast<double>(n - std::abs(difference)) * correlation[at]
                       : 0;
        }
        merged.diagonal(lag).setConstant(sum / static_cast<double>(n));
        merged.diagonal(-lag).setConstant(sum / static_cast<double>(n));
    }
    return merged;
}

}  // namespace

Eigen::MatrixXd part_covariance(const NoiseShape& shape, const ResidualSeries& run) {
    const Eigen::VectorXd scale =
        shape.of_phase ? Eigen::VectorXd(run.size / std::sqrt(run.size.squaredNorm() /
                                                              static_cast<double>(run.size.size())))
                       : run.noise;
    return scale.asDiagonal() * shape_covariance(shape, run.time_s, run.window_s) *
           scale.asDiagonal();
}

ResidualSeries residual_series(const FitProblem& problem, const Posterior& posterior,
                               std::size_t index, std::size_t merge) {
    const ScaledRun& run = problem.runs[index];
    const Linearised& at = posterior.runs[index];
    const auto points = static_cast<Eigen::Index>(run.size() / merge);
    ResidualSeries out;
    std::vector<Eigen::Index> column_of;  // a run's derivatives at each of the places
    const Eigen::Index first_own = problem.layout.at(index, 0);
    for (std::size_t k = 0; k < posterior.active.size(); ++k) {
        const Eigen::Index parameter = posterior.active[k];
        const bool own =
            parameter >= first_own && parameter < first_own + problem.layout.own_size(index);
        if (parameter < shared_count || own) {
            out.places.push_back(static_cast<Eigen::Index>(k));
            column_of.push_back(own ? parameter - first_own + shared_count : parameter);
        }
    }

    const double usual_sd = 1 / median(run.weight);
    const double share = 1 / static_cast<double>(merge);
    const double keeps_noise = std::sqrt(share);
    out.window_s = run.window_s * static_cast<double>(merge);
    out.correlation = merged_correlation(run.correlation, merge, points);
    out.time_s.assign(static_cast<std::size_t>(points), 0);
    out.size = out.noise = Eigen::VectorXd::Zero(points);
    out.residual.fill(Eigen::VectorXd::Zero(points));
    out.by_parameter.fill(
        Eigen::MatrixXd::Zero(points, static_cast<Eigen::Index>(column_of.size())));
    for (Eigen::Index k = 0; k < points * static_cast<Eigen::Index>(merge); ++k) {
        const auto window = static_cast<std::size_t>(k);
        const Eigen::Index point = k / static_cast<Eigen::Index>(merge);
        const double weight = run.weight[window];
        const auto left = at.residual.segment<4>(4 * k);
        // Noise of both channels is alike in the frame of the whitened channels.
        const Vector2cd y = run.whitening * run.z[window];
        const Vector2cd z =
            y - Vector2cd(Complex(left[0], left[1]), Complex(left[2], left[3])) / weight;
        const double size = z.norm();
        const Vector2cd u = z / size;
        const Vector2cd v(-std::conj(u[1]), std::conj(u[0]));
        const Complex along_y = u.dot(y) / size;
        const bool clear = size * weight > clear_amplitude;
        const Complex along = weight * size * (clear ? std::log(along_y) : along_y - 1.0);
        const Complex turn = clear ? std::polar(1.0, -std::arg(along_y)) : 1.0;
        const Complex across = weight * v.dot(y) * turn;
        const std::array<double, 4> residual{along.real(), along.imag(), across.real(),
                                             across.imag()};
        const std::array<Vector2cd, 4> axis{u, i * u, v, i * v};
        out.time_s[static_cast<std::size_t>(point)] += share * run.time_s[window];
        out.size[point] += share * weight * size;
        out.noise[point] += share * usual_sd * weight;
        for (std::size_t s = 0; s < 4; ++s) {
            out.residual[s][point] += keeps_noise * residual[s];
            const Eigen::RowVector4d row(axis[s][0].real(), axis[s][0].imag(), axis[s][1].real(),
                                         axis[s][1].imag());
            const Eigen::RowVectorXd by = row * at.by_parameter.middleRows<4>(4 * k);
            out.by_parameter[s].row(point) += keeps_noise * by(column_of);
        }
    }
    return out;
}

}  // namespace vybeg
