#include "core/resonator/runs/mean_rate.h"

#include "core/numerics/dense_solvers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vybeg {
namespace {

constexpr Eigen::Index most_blocks = 48;

constexpr Eigen::Index straight = 1;
constexpr Eigen::Index parabola = 2;

// The parts' constants and powers of time over the series, from -1 to 1, times the weights.
Eigen::MatrixXd trend_functions(const Eigen::VectorXd& t, const Eigen::VectorXd& root_weight,
                                const std::vector<std::size_t>& part, Eigen::Index order) {
    const auto parts = static_cast<Eigen::Index>(part.empty() ? 1 : part.back() + 1);
    const Eigen::ArrayXd from_middle = t.array() - (t.minCoeff() + t.maxCoeff()) / 2;
    const Eigen::VectorXd scaled = from_middle / from_middle.maxCoeff();
    Eigen::MatrixXd functions = Eigen::MatrixXd::Zero(t.size(), parts + order);
    for (Eigen::Index k = 0; k < t.size(); ++k) {
        const std::size_t own = part.empty() ? 0 : part[static_cast<std::size_t>(k)];
        functions(k, static_cast<Eigen::Index>(own)) = root_weight[k];
    }
    for (Eigen::Index k = 1; k <= order; ++k) {
        functions.col(parts + k - 1) =
            root_weight.array() * scaled.array().pow(static_cast<double>(k));
    }
    return functions;
}

Eigen::Map<const Eigen::VectorXd> view(const std::vector<double>& values) {
    return {values.data(), std::ssize(values)};
}

// Least-squares trend, and its last coefficient over its deviation in white noise.
struct FittedSeries {
    Eigen::VectorXd value;
    double last_over_sd = 0;
};

FittedSeries fitted_trend(const RateSeries& series, Eigen::Index order) {
    const Eigen::VectorXd root_weight = view(series.sd).cwiseInverse();
    const Eigen::MatrixXd functions =
        trend_functions(view(series.time_s), root_weight, series.part, order);
    const Eigen::VectorXd weighted = view(series.value).cwiseProduct(root_weight);
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(functions);
    const Eigen::Index last = functions.cols() - 1;
    // The last row of R belongs to the last coefficient alone.
    const Eigen::VectorXd rotated = qr.householderQ().transpose() * weighted;
    return {
        (functions * functions.colPivHouseholderQr().solve(weighted)).cwiseQuotient(root_weight),
        rotated[last]};
}

// Least curvature, in deviations, attributed to the wave; a smaller one may be noise about the
// carrier and counts as noise.
constexpr double own_bend = 8;

Eigen::Index order_of(const RateSeries& series) {
    return std::abs(fitted_trend(series, parabola).last_over_sd) > own_bend ? parabola : straight;
}

// Means over blocks of consecutive windows.
struct Blocks {
    Eigen::VectorXd time_s;
    Eigen::VectorXd value;  // less the trend, in units of sd
    Eigen::VectorXd sd;
    Eigen::VectorXd line;  // coefficients of the slope, times sd
    std::vector<std::size_t> part;
    double length_s = 0;
    Eigen::Index order = straight;  // of the trend
};

Blocks blocks_of(const RateSeries& series, const Eigen::VectorXd& coefficients, double inflation) {
    const auto t = view(series.time_s);
    const Eigen::Index order = order_of(series);
    const Eigen::VectorXd residual = view(series.value) - fitted_trend(series, order).value;
    const Eigen::VectorXd weight = view(series.sd).cwiseAbs2().cwiseInverse() / inflation;
    const Eigen::Index n = t.size();
    const Eigen::Index count = std::min(n, most_blocks);
    Blocks blocks{Eigen::VectorXd(count),
                  Eigen::VectorXd(count),
                  Eigen::VectorXd(count),
                  Eigen::VectorXd(count),
                  {},
                  (t[n - 1] - t[0]) / static_cast<double>(std::max<Eigen::Index>(n - 1, 1)) *
                      static_cast<double>(n) / static_cast<double>(count),
                  order};
    for (Eigen::Index b = 0; b < count; ++b) {
        const Eigen::Index first = b * n / count;
        const Eigen::Index size = (b + 1) * n / count - first;
        const auto w = weight.segment(first, size);
        const double sum = w.sum();
        blocks.time_s[b] = w.dot(t.segment(first, size)) / sum;
        blocks.sd[b] = 1 / std::sqrt(sum);
        blocks.value[b] = w.dot(residual.segment(first, size)) / sum / blocks.sd[b];
        if (!series.part.empty()) {
            blocks.part.push_back(series.part[static_cast<std::size_t>(first)]);
        }
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

// Amounts a of coloured noise that are tried, and widths w of its line.
std::vector<double> amounts() {
    std::vector<double> tried;
    for (double a = 1e-2; a < 1e14; a *= 1.5848931924611136) {
        tried.push_back(a);
    }
    return tried;
}

std::vector<double> widths(const Blocks& blocks) {
    constexpr double narrowest = 0.28;  // of 1/T
    std::vector<double> tried;
    const auto count = static_cast<double>(blocks.time_s.size());
    for (double share = narrowest / count; share < 2; share *= 2) {
        tried.push_back(share / blocks.length_s);
    }
    return tried;
}

// For each width and amount: rise of the logarithm of the likelihood over that of white noise, and
// contribution of the coloured noise to the variance of the slope.
struct Evidence {
    std::vector<double> rise;
    std::vector<double> added;
    double most = 0;  // of the rise
};

Evidence evidence_of(const Blocks& blocks, const std::vector<double>& tried_widths,
                     const JobControl& job) {
    const Eigen::Index n = blocks.time_s.size();
    const Eigen::MatrixXd absorbed =
        trend_functions(blocks.time_s, blocks.sd.cwiseInverse(), blocks.part, blocks.order);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(absorbed);
    const Eigen::MatrixXd all = qr.householderQ() * Eigen::MatrixXd::Identity(n, n);
    const Eigen::MatrixXd left = all.rightCols(n - qr.rank());
    const Eigen::VectorXd x = left.transpose() * blocks.value;
    Evidence evidence;
    for (const double w : tried_widths) {
        if (job.cancelled()) {
            evidence.rise.resize(tried_widths.size() * amounts().size());
            evidence.added.resize(evidence.rise.size());
            return evidence;
        }
        const Eigen::MatrixXd correlation = lorentz(blocks, 6.283185307179586 * w);
        const double on_line = blocks.line.dot(correlation * blocks.line);
        const Eigen::MatrixXd seen = left.transpose() * correlation * left;
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(seen);
        const Eigen::ArrayXd size = eigen.eigenvalues().array().max(0.0);
        const Eigen::ArrayXd square = (eigen.eigenvectors().transpose() * x).array().square();
        for (const double a : amounts()) {
            const Eigen::ArrayXd v = 1 + a * size;
            const double rise = 0.5 * (square - v.log() - square / v).sum();
            evidence.rise.push_back(std::isfinite(rise) ? rise : 0);
            evidence.added.push_back(a * on_line);
            evidence.most = std::max(evidence.most, evidence.rise.back());
        }
    }
    return evidence;
}

// Contribution of coloured noise to the variance of one slope, by the likelihood of all series.
double added_by_colour(const std::vector<Evidence>& all, std::size_t own) {
    constexpr double least_rise = 3;
    // A series with more evidence than this may be curved instead and does not affect the others.
    constexpr double most_shared = 30;
    std::vector<double> rise = all[own].rise;
    for (std::size_t j = 0; j < all.size(); ++j) {
        for (std::size_t k = 0; k < rise.size() && j != own && all[j].most < most_shared; ++k) {
            rise[k] += all[j].rise[k];
        }
    }
    const double best = *std::ranges::max_element(rise);
    if (best < least_rise) {
        return 0;
    }
    double weights = 0;
    double sum = 0;
    for (std::size_t k = 0; k < rise.size(); ++k) {
        const double weight = std::exp(rise[k] - best);
        weights += weight;
        sum += weight * all[own].added[k];
    }
    return sum / weights;
}

// Coefficients of the slope: each part's times count from its own weighted mean.
Eigen::VectorXd slope_coefficients(const RateSeries& series) {
    const auto t = view(series.time_s);
    const Eigen::VectorXd weight = view(series.sd).cwiseAbs2().cwiseInverse();
    Eigen::VectorXd lever(t.size());
    for (Eigen::Index first = 0; first < t.size();) {
        Eigen::Index end = t.size();
        if (!series.part.empty()) {
            const auto begin = series.part.begin();
            end = std::upper_bound(begin, series.part.end(), begin[first]) - begin;
        }
        const auto w = weight.segment(first, end - first);
        const auto own = t.segment(first, end - first);
        const double mean_s = w.dot(own) / w.sum();
        lever.segment(first, end - first) = w.array() * (own.array() - mean_s);
        first = end;
    }
    return lever / lever.dot(t);
}

}  // namespace

std::vector<double> trend_of(const RateSeries& series) {
    const Eigen::VectorXd trend = fitted_trend(series, parabola).value;
    return {trend.begin(), trend.end()};
}

std::vector<Estimate> mean_slopes(std::span<const RateSeries> series) {
    std::vector<Estimate> rates;
    for (const RateSeries& one : series) {
        rates.emplace_back().value = slope_coefficients(one).dot(view(one.value));
    }
    return rates;
}

std::vector<Estimate> mean_rates(std::span<const RateSeries> series, double inflation,
                                 const JobControl& job) {
    std::vector<Eigen::VectorXd> coefficients;
    std::vector<Evidence> evidence;
    std::vector<double> tried;
    for (const RateSeries& one : series) {
        coefficients.push_back(slope_coefficients(one));
        const Blocks blocks = blocks_of(one, coefficients.back(), inflation);
        tried = tried.empty() ? widths(blocks) : tried;
        evidence.push_back(evidence_of(blocks, tried, job));
    }
    std::vector<Estimate> rates;
    for (std::size_t s = 0; s < series.size(); ++s) {
        const Eigen::VectorXd& slope = coefficients[s];
        const auto sd = view(series[s].sd);
        const double white = inflation * slope.cwiseProduct(sd).squaredNorm();
        double added = 0;
        double later = 0;  // the slope's coefficients from here on
        for (Eigen::Index k = std::ssize(series[s].step_variance); k-- > 0;) {
            later += slope[k];
            added += later * later * series[s].step_variance[static_cast<std::size_t>(k)];
        }
        rates.push_back(
            {slope.dot(view(series[s].value)),
             std::sqrt(white + added_by_colour(evidence, s) + inflation * std::max(added, 0.0)),
             {}});
    }
    return rates;
}

}  // namespace vybeg
