#include "core/resonator/noise/noise_claim.h"

#include "core/numerics/dense_solvers.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// One series of one run under the claim.
struct ClaimedSeries {
    VectorXd residual;
    MatrixXd by_root;  // derivatives in the basis of the posterior's root
    MatrixXd windows;  // covariance of the windows' noise
    MatrixXd colour;   // of the further parts; empty: none

    // First row and number of rows of a half.
    std::pair<Index, Index> rows(std::size_t half) const {
        const Index first = residual.size() / 2;
        return half == 0 ? std::pair(Index{0}, first) : std::pair(first, residual.size() - first);
    }
    MatrixXd covariance() const { return colour.size() > 0 ? MatrixXd(windows + colour) : windows; }
};

// A run depends on few of the parameters of a large set.
MatrixXd in_root(const MatrixXd& by_parameter, const MatrixXd& root) {
    std::vector<Index> own;
    for (Index k = 0; k < by_parameter.cols(); ++k) {
        if (!by_parameter.col(k).isZero(0)) {
            own.push_back(k);
        }
    }
    return by_parameter(Eigen::all, own) * root(own, Eigen::all);
}

std::vector<ClaimedSeries> claimed_series(const NoiseEstimate& noise, const Posterior& posterior,
                                          const JobControl& job) {
    std::vector<ClaimedSeries> all;
    const bool any_common = std::ranges::any_of(
        noise.parts, [](const ResidualNoise::Part& part) { return !part.shape.of_phase; });
    for (const ResidualSeries& run : noise.series) {
        if (job.cancelled()) {
            return all;
        }
        const Index n = run.size.size();
        const auto [common, of_phase] = noise.part_sums(run);
        for (std::size_t s = 0; s < 4; ++s) {
            ClaimedSeries series{
                run.residual[s],
                in_root(run.by_parameter[s], posterior.root),
                run.correlation.size() > 0 ? run.correlation : MatrixXd(MatrixXd::Identity(n, n)),
                {}};
            if (s == ResidualSeries::phase && !noise.parts.empty()) {
                series.colour = common + of_phase;
            } else if (any_common) {
                series.colour = common;
            }
            all.push_back(std::move(series));
        }
    }
    return all;
}

// What the parameters absorb of the rows [first, first + count) of a series: orthonormal columns.
MatrixXd absorbed_by(const ClaimedSeries& series, Index first, Index count) {
    constexpr double share = 0.02;  // as in the estimate
    const MatrixXd seen = series.by_root.middleRows(first, count);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> principal(MatrixXd(seen * seen.transpose()));
    Index columns = 0;
    while (columns + 1 < count && principal.eigenvalues()[count - 1 - columns] > share) {
        ++columns;
    }
    return principal.eigenvectors().rightCols(columns);
}

// Twice the rise of the logarithm of the likelihood of a half if it has its own amount of colour.
double rise_of_half(const ClaimedSeries& series, Index first, Index count) {
    constexpr double least_decade = -6;
    constexpr double most_decade = 6;
    constexpr double step = 0.5;
    const MatrixXd absorbed = absorbed_by(series, first, count);
    const VectorXd x = series.residual.segment(first, count);
    const auto likelihood = [&](double amount) {
        const Eigen::LLT<MatrixXd> factor(
            MatrixXd(series.windows.block(first, first, count, count) +
                     amount * series.colour.block(first, first, count, count)));
        const VectorXd left = factor.matrixL().solve(x);
        const MatrixXd out = factor.matrixL().solve(absorbed);
        double logarithm = 2 * factor.matrixLLT().diagonal().array().log().sum();
        double square = left.squaredNorm();
        if (absorbed.cols() > 0) {
            const Eigen::LLT<MatrixXd> inner(MatrixXd(out.transpose() * out));
            const VectorXd along = inner.matrixL().solve(out.transpose() * left);
            square -= along.squaredNorm();
            logarithm += 2 * inner.matrixLLT().diagonal().array().log().sum();
        }
        return -(logarithm + square);
    };
    const double claimed = likelihood(1);
    double best = claimed;
    for (double decade = least_decade; decade <= most_decade; decade += step) {
        const double other = likelihood(std::pow(10, decade));
        best = other > best ? other : best;
    }
    return std::isfinite(best - claimed) ? best - claimed : 0;
}

// Normal deviate of the rise of the likelihood if each half of each series has its own amount of
// colour.
double deviate_of_likelihood(const std::vector<ClaimedSeries>& all, const JobControl& job) {
    double rise = 0;
    double count = 0;
    for (const ClaimedSeries& series : all) {
        if (series.colour.size() == 0 || series.residual.size() < 8 || job.cancelled()) {
            continue;
        }
        for (const std::size_t half : {0, 1}) {
            const auto [first, rows] = series.rows(half);
            rise += rise_of_half(series, first, rows);
            count += 1;
        }
    }
    return count > 0 ? (rise - count) / std::sqrt(2 * count) : 0;
}

// The difference of the parameters between the halves, and its normal deviate.
double deviate_of_parameters(const std::vector<ClaimedSeries>& all, const Posterior& posterior,
                             VectorXd& difference) {
    // A direction that a half does not show stays within thirty deviations of the whole.
    constexpr double ridge = 1e-3;
    const Index size = posterior.covariance.rows();
    std::array<MatrixXd, 2> square;
    std::array<VectorXd, 2> toward;
    for (const std::size_t half : {0, 1}) {
        square[half] = posterior.known + posterior.nothing;
        square[half].diagonal().array() += ridge;
        toward[half] = VectorXd::Zero(size);
    }
    for (const ClaimedSeries& series : all) {
        for (const std::size_t half : {0, 1}) {
            const auto [first, count] = series.rows(half);
            const auto by = series.by_root.middleRows(first, count);
            square[half] += by.transpose() * by;
            toward[half] += by.transpose() * series.residual.segment(first, count);
        }
    }
    std::array<MatrixXd, 2> inverse;
    for (const std::size_t half : {0, 1}) {
        inverse[half] = square[half].ldlt().solve(MatrixXd::Identity(size, size));
    }
    difference = inverse[0] * toward[0] - inverse[1] * toward[1];
    // The difference as a function of the noise of all rows, less what the whole fit absorbs.
    std::vector<MatrixXd> by_row;
    MatrixXd along = MatrixXd::Zero(size, size);
    for (const ClaimedSeries& series : all) {
        MatrixXd by(series.by_root.rows(), size);
        for (const std::size_t half : {0, 1}) {
            const auto [first, count] = series.rows(half);
            by.middleRows(first, count) =
                (half == 0 ? 1 : -1) * series.by_root.middleRows(first, count) * inverse[half];
        }
        along += series.by_root.transpose() * by;
        by_row.push_back(std::move(by));
    }
    MatrixXd covariance = MatrixXd::Zero(size, size);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const MatrixXd left = by_row[k] - all[k].by_root * along;
        covariance += left.transpose() * all[k].covariance() * left;
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(covariance);
    const VectorXd turned = eigen.eigenvectors().transpose() * difference;
    double square_sum = 0;
    double count = 0;
    for (Index k = 0; k < size; ++k) {
        constexpr double least = 0.01;  // variance, that of the whole fit is 1
        if (eigen.eigenvalues()[k] > least) {
            square_sum += turned[k] * turned[k] / eigen.eigenvalues()[k];
            count += 1;
        }
    }
    return count > 0 ? chi2_deviations(square_sum, count) : 0;
}

}  // namespace

NoiseClaim noise_claim(const NoiseEstimate& noise, const Posterior& posterior,
                       const JobControl& job) {
    NoiseClaim claim;
    claim.difference = VectorXd::Zero(posterior.covariance.rows());
    const std::vector<ClaimedSeries> all = claimed_series(noise, posterior, job);
    if (job.cancelled() || all.empty()) {
        return claim;
    }
    claim.holds = deviate_of_likelihood(all, job) < 8;
    // The cost grows with the cube of the number of recordings.
    constexpr Index most_parameters = 150;
    if (posterior.covariance.rows() <= most_parameters) {
        const double apart = deviate_of_parameters(all, posterior, claim.difference);
        claim.holds = claim.holds && apart < 5;
    }
    return claim;
}

}  // namespace vybeg
