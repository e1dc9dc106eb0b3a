#include "core/track/track_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double most_blocks = 256;
constexpr double least_correlations = 2;  // lengths of the correlation in a block
constexpr std::size_t least_blocks = 20;
constexpr std::size_t most_at_bound = 1 << 16;  // kept until there is a mean
constexpr double significant_scatter = 3;       // standard deviations

constexpr Flags harmless = static_cast<Flags>(Flag::no_quadrature);

}  // namespace

std::vector<double> overlap_correlation(double independent) {
    std::vector<double> correlation;
    double x = 0;
    for (std::size_t lag = 0; x < 1; x = static_cast<double>(++lag) * independent) {
        correlation.push_back(1 - 3 * x + 2 * x * x * x);
    }
    return correlation;
}

TrackSummariser::TrackSummariser(std::size_t rows, double independent,
                                 std::vector<double> correlation)
    : independent_(std::min(1.0, independent)),
      correlation_(correlation.empty() ? overlap_correlation(independent_)
                                       : std::move(correlation)) {
    const auto lags = static_cast<double>(correlation_.size());
    block_length_ = std::max(std::ceil(static_cast<double>(rows) / most_blocks),
                             lags > 1 ? least_correlations * lags : 1.0);
}

void TrackSummariser::take(const Track& rows) {
    const auto f = rows.values(SlowVariable::f);
    const auto sd = rows.sds(SlowVariable::f);
    const auto noise = rows.values(SlowVariable::noise);
    const auto flags = rows.flags();
    counts_.windows += rows.rows();
    for (std::size_t k = 0; k < rows.rows(); ++k) {
        counts_.flagged += (flags[k] & static_cast<Flags>(~harmless)) != 0 ? 1 : 0;
        counts_.at_bound += has(flags[k], Flag::at_bound) ? 1 : 0;
        counts_.leaking += has(flags[k], Flag::leakage) ? 1 : 0;
        if (std::isfinite(noise[k])) {
            (is_sound_window(flags[k]) ? noise_ : noise_of_invalid_).take(noise[k] * noise[k]);
        }
        if (!std::isfinite(f[k])) {
            continue;
        }
        if (is_sound_window(flags[k])) {
            take_frequency(rows.time_s()[k], f[k], sd[k], rows.leakage_f_hz()[k]);
        } else if (has(flags[k], Flag::at_bound) && !has(flags[k], Flag::gap)) {
            if (count_ > 0) {
                (f[k] < mean_ ? below_ : above_).take(f[k]);
            } else if (at_bound_.size() < most_at_bound) {
                at_bound_.push_back(f[k]);
            }
        }
    }
}

void TrackSummariser::take_frequency(double time_s, double f, double sd, double leakage) {
    // Welford's recurrence, because the frequencies agree to seven digits and a difference of sums
    // of squares would lose the scatter.
    count_ += 1;
    const double step = f - mean_;
    mean_ += step / count_;
    spread_ += step * (f - mean_);
    if (blocks_.empty() || blocks_.back().count >= block_length_) {
        blocks_.emplace_back();
    }
    Block& block = blocks_.back();
    block.count += 1;
    block.mean += (f - block.mean) / block.count;
    block.time_s += (time_s - block.time_s) / block.count;
    block.variance += sd * sd;
    block.leakage += leakage;
}

// Of the mean of f over a block.
double TrackSummariser::variance_of(const Block& block) const {
    double sum = block.count;
    for (std::size_t lag = 1; lag < correlation_.size(); ++lag) {
        const double pairs = block.count - static_cast<double>(lag);
        if (pairs <= 0) {
            break;
        }
        sum += 2 * pairs * correlation_[lag];
    }
    // Rounding of a sum that nearly cancels.
    sum = std::max(sum, 1e-3);
    return block.variance / block.count * sum / (block.count * block.count);
}

double TrackSummariser::covariance_of(const Block& block, const Block& next) const {
    double sum = 0;
    const double all = block.count + next.count;
    for (std::size_t lag = 1; lag < correlation_.size(); ++lag) {
        const auto hops = static_cast<double>(lag);
        const double pairs = std::min({hops, block.count, next.count, all - hops});
        if (pairs <= 0) {
            break;
        }
        sum += pairs * correlation_[lag];
    }
    return std::sqrt(block.variance / block.count * next.variance / next.count) * sum /
           (block.count * next.count);
}

// Mean square of the second differences of the blocks' means in units of their variance, less 1.
double TrackSummariser::excess(std::span<const double> variances,
                               std::span<const double> covariances) const {
    double sum = 0;
    for (std::size_t i = 2; i < blocks_.size(); ++i) {
        // Blocks that a gap has shifted are not evenly apart.
        const double before = blocks_[i - 1].time_s - blocks_[i - 2].time_s;
        const double after = blocks_[i].time_s - blocks_[i - 1].time_s;
        const double share = before > 0 && after > 0 ? after / (before + after) : 0.5;
        const double bend =
            share * blocks_[i - 2].mean + (1 - share) * blocks_[i].mean - blocks_[i - 1].mean;
        const double variance = share * share * variances[i - 2] + variances[i - 1] +
                                (1 - share) * (1 - share) * variances[i] -
                                2 * (share * covariances[i - 2] + (1 - share) * covariances[i - 1]);
        sum += bend * bend / variance;
    }
    return sum / (static_cast<double>(blocks_.size()) - 2) - 1;
}

TrackSummary TrackSummariser::summary() const {
    TrackSummary summary = counts_;
    summary.mean_f_hz = summary.sd_mean_f_hz = summary.scatter_f_hz = summary.mean_at_s = nan;
    const Sum& noise = noise_.count > 0 ? noise_ : noise_of_invalid_;
    summary.noise = std::sqrt(noise.sum / noise.count);  // NaN for none
    if (count_ == 0) {
        return summary;
    }
    const bool weighted =
        std::ranges::all_of(blocks_, [](const Block& b) { return b.variance > 0; });
    std::vector<double> variances;
    std::vector<double> covariances;
    for (const Block& b : blocks_) {
        variances.push_back(weighted ? variance_of(b) : 1 / b.count);
    }
    for (std::size_t i = 1; i < blocks_.size(); ++i) {
        covariances.push_back(weighted ? covariance_of(blocks_[i - 1], blocks_[i]) : 0);
    }
    double weights = 0;
    double offset = 0;  // from the plain mean, to keep digits
    double leakage = 0;
    double time_s = 0;
    double products = 0;  // of all pairs of blocks
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const Block& b = blocks_[i];
        const double weight = 1 / variances[i];
        weights += weight;
        offset += weight * (b.mean - mean_);
        time_s += weight * (b.time_s - blocks_[0].time_s);
        leakage += weight * b.leakage / b.count;
        products += i > 0 ? 2 * weight * covariances[i - 1] / variances[i - 1] : 0;
    }
    summary.mean_f_hz = mean_ + offset / weights;
    summary.mean_at_s = blocks_[0].time_s + time_s / weights;
    summary.leakage_f_hz = std::abs(leakage / weights);
    if (count_ < 2) {
        return summary;
    }
    const auto blocks = static_cast<double>(blocks_.size());
    double variance = 0;
    if (!weighted) {
        variance = spread_ / (count_ - 1) / (count_ * independent_);
    } else {
        // The sum of weights is that of weight^2 variance. The rest of a sum that cancels is not
        // below that of its two ends.
        variance = std::max(weights + products, weights / blocks / 4) / (weights * weights);
    }
    if (blocks_.size() > 2) {
        const double beyond = excess(variances, covariances);
        if (!weighted) {
            variance = blocks_.size() < least_blocks ? variance : (1 + beyond) / weights;
        } else if (blocks_.size() < least_blocks) {
            variance *= std::max(1.0, 1 + beyond);
        } else if (beyond > significant_scatter * std::sqrt(4 / (blocks - 2))) {
            variance += beyond / weights;
        }
    }
    double distances = below_.count * summary.mean_f_hz - below_.sum + above_.sum -
                       above_.count * summary.mean_f_hz;
    for (const double f : at_bound_) {
        distances += std::abs(f - summary.mean_f_hz);
    }
    const double hidden =
        distances / (count_ + below_.count + above_.count + static_cast<double>(at_bound_.size()));
    summary.scatter_f_hz = std::sqrt(variance);
    summary.sd_mean_f_hz =
        std::sqrt(variance + summary.leakage_f_hz * summary.leakage_f_hz + hidden * hidden);
    return summary;
}

TrackSummary summarise(const Track& track, double independent, std::vector<double> correlation) {
    TrackSummariser summariser(track.rows(), independent, std::move(correlation));
    summariser.take(track);
    return summariser.summary();
}

}  // namespace vybeg
