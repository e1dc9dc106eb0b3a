#include "core/resonator/mean_rate.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vybeg {
namespace {

constexpr Eigen::Index most_blocks = 48;

Eigen::Index trend_order(Eigen::Index values) {
    return std::min<Eigen::Index>(4, values / 4);
}

// Powers of time over the series, from -1 to 1, times the weights.
Eigen::MatrixXd trend_functions(const Eigen::VectorXd& t, const Eigen::VectorXd& root_weight) {
    const double middle = (t.minCoeff() + t.maxCoeff()) / 2;
    const double half = (t.maxCoeff() - t.minCoeff()) / 2;
    Eigen::MatrixXd functions(t.size(), trend_order(t.size()) + 1);
    functions.col(0) = root_weight;
    for (Eigen::Index k = 1; k < functions.cols(); ++k) {
        functions.col(k) =
            functions.col(k - 1).cwiseProduct(((t.array() - middle) / half).matrix());
    }
    return functions;
}

Eigen::Map<const Eigen::VectorXd> view(const std::vector<double>& values) {
    return {values.data(), std::ssize(values)};
}

// Means over blocks of consecutive windows.
struct Blocks {
    Eigen::VectorXd time_s;
    Eigen::VectorXd value;  // less the trend, in units of sd
    Eigen::VectorXd sd;
    Eigen::VectorXd line;  // coefficients of the slope, times sd
    double length_s = 0;
};

Blocks blocks_of(const RateSeries& series, const Eigen::VectorXd& coefficients, double inflation) {
    const auto t = view(series.time_s);
    const Eigen::VectorXd residual = view(series.value) - view(trend_of(series));
    const Eigen::VectorXd weight = view(series.sd).cwiseAbs2().cwiseInverse() / inflation;
    const Eigen::Index n = t.size();
    const Eigen::Index count = std::min(n, most_blocks);
    Blocks blocks{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::VectorXd(count),
                  Eigen::VectorXd(count),
                  (t[n - 1] - t[0]) / static_cast<double>(std::max<Eigen::Index>(n - 1, 1)) *
                      static_cast<double>(n) / static_cast<double>(count)};
    for (Eigen::Index b = 0; b < count; ++b) {
        const Eigen::Index first = b * n / count;
        const Eigen::Index size = (b + 1) * n / count - first;
        const auto w = weight.segment(first, size);
        const double sum = w.sum();
        blocks.time_s[b] = w.dot(t.segment(first, size)) / sum;
        blocks.sd[b] = 1 / std::sqrt(sum);
        blocks.value[b] = w.dot(residual.segment(first, size)) / sum / blocks.sd[b];
        blocks.line[b] = coefficients.segment(first, size).sum() * blocks.sd[b];
    }
    return blocks;
}

// Correlation of a Lorentz line of half width w (b = 2 pi w) in means over blocks.
Eigen::MatrixXd lorentz(const Blocks& blocks, double b) {
    const double bh = b * blocks.length_s;
    const double mean = (1 - std::exp(-bh)) / bh;
    const Eigen::Index n = blocks.time_s.size();
    Eigen::MatrixXd correlation(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            const double lag = std::abs(blocks.time_s[i] - blocks.time_s[j]);
            correlation(i, j) = i == j ? 2 * (bh - 1 + std::exp(-bh)) / (bh * bh)
                                       : mean * mean * std::exp(-std::max(b * lag - bh, 0.0));
        }
    }
    return correlation;
}

// Variance of the slope in units of what white noise of the windows' deviations makes it.
double excess(const Blocks& blocks) {
    constexpr double least_rise = 4;
    constexpr double narrowest = 0.28;  // of 1/T, half width
    const Eigen::Index n = blocks.time_s.size();
    const double white = blocks.line.squaredNorm();
    const Eigen::MatrixXd absorbed = trend_functions(blocks.time_s, blocks.sd.cwiseInverse());
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(absorbed);
    const Eigen::MatrixXd all = qr.householderQ() * Eigen::MatrixXd::Identity(n, n);
    const Eigen::MatrixXd left = all.rightCols(n - absorbed.cols());
    const Eigen::VectorXd x = left.transpose() * blocks.value;
    const double none = -0.5 * x.squaredNorm();
    const double total_s = blocks.length_s * static_cast<double>(n);
    std::vector<double> likelihoods;
    std::vector<double> variances;
    for (double w = narrowest / total_s; w < 2 / blocks.length_s; w *= 2) {
        const Eigen::MatrixXd correlation = lorentz(blocks, 6.283185307179586 * w);
        const double on_line = blocks.line.dot(correlation * blocks.line);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(left.transpose() * correlation *
                                                                   left);
        const Eigen::ArrayXd size = eigen.eigenvalues().array().max(0.0);
        const Eigen::ArrayXd square = (eigen.eigenvectors().transpose() * x).array().square();
        for (double a = 0.1 / size.maxCoeff(); a < 1e12 / size.maxCoeff();
             a *= 1.5848931924611136) {
            const Eigen::ArrayXd v = 1 + a * size;
            likelihoods.push_back(-0.5 * (v.log() + square / v).sum());
            variances.push_back(white + a * on_line);
        }
    }
    const double best = *std::ranges::max_element(likelihoods);
    if (best < none + least_rise) {
        return 1;
    }
    double weights = 0;
    double sum = 0;
    for (std::size_t k = 0; k < likelihoods.size(); ++k) {
        const double weight = std::exp(likelihoods[k] - best);
        weights += weight;
        sum += weight * variances[k];
    }
    return sum / weights / white;
}

}  // namespace

std::vector<double> trend_of(const RateSeries& series) {
    const Eigen::VectorXd root_weight = view(series.sd).cwiseInverse();
    const Eigen::MatrixXd functions = trend_functions(view(series.time_s), root_weight);
    const Eigen::VectorXd weighted = view(series.value).cwiseProduct(root_weight);
    const Eigen::VectorXd fitted =
        (functions * functions.householderQr().solve(weighted)).cwiseQuotient(root_weight);
    return {fitted.begin(), fitted.end()};
}

MeanRate mean_rate(const RateSeries& series, double inflation) {
    const auto t = view(series.time_s);
    const Eigen::VectorXd weight = view(series.sd).cwiseAbs2().cwiseInverse();
    const double mean_s = weight.dot(t) / weight.sum();
    const Eigen::VectorXd lever = weight.cwiseProduct((t.array() - mean_s).matrix());
    const Eigen::VectorXd coefficients = lever / lever.dot(t);
    const double white = inflation * coefficients.cwiseProduct(view(series.sd)).squaredNorm();
    return {coefficients.dot(view(series.value)),
            std::sqrt(white * excess(blocks_of(series, coefficients, inflation)))};
}

}  // namespace vybeg
