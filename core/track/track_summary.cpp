#include "core/track/track_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vybeg {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double most_blocks = 256;
constexpr double least_overlaps = 8;  // window lengths in a block
constexpr std::size_t least_blocks = 20;

constexpr Flags harmless = static_cast<Flags>(Flag::no_quadrature);
constexpr Flags invalid = static_cast<Flags>(Flag::gap | Flag::clipped) |
                          static_cast<Flags>(Flag::not_converged | Flag::at_bound) |
                          static_cast<Flags>(Flag::filter_transient | Flag::delay_reach);

}  // namespace

TrackSummariser::TrackSummariser(std::size_t rows, double independent)
    : independent_(std::min(1.0, independent)),
      block_length_(std::max(std::ceil(static_cast<double>(rows) / most_blocks),
                             independent_ < 1 ? std::ceil(least_overlaps / independent_) : 1.0)) {}

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
        counts_.moving += has(flags[k], Flag::moving) ? 1 : 0;
        if (std::isfinite(noise[k])) {
            ((flags[k] & invalid) == 0 ? noise_ : noise_of_invalid_).take(noise[k]);
        }
        if (!std::isfinite(f[k])) {
            continue;
        }
        if ((flags[k] & invalid) == 0) {
            take_frequency(f[k], sd[k], rows.leakage_f_hz()[k]);
        } else if (has(flags[k], Flag::at_bound) && !has(flags[k], Flag::gap)) {
            Beyond& side = f[k] < mean_ ? below_ : above_;
            side.count += 1;
            side.sum += f[k];
        }
    }
}

void TrackSummariser::take_frequency(double f, double sd, double leakage) {
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
    block.variance += sd * sd;
    block.leakage += leakage;
}

TrackSummary TrackSummariser::summary() const {
    TrackSummary summary = counts_;
    summary.mean_f_hz = summary.sd_mean_f_hz = summary.scatter_f_hz = nan;
    summary.noise = noise_.count > 0 ? noise_.root() : noise_of_invalid_.root();
    if (count_ == 0) {
        return summary;
    }
    const bool weighted =
        std::ranges::all_of(blocks_, [](const Block& b) { return b.variance > 0; });
    const auto weight = [weighted](const Block& b) {
        return weighted ? b.count * b.count / b.variance : b.count;
    };
    double weights = 0;
    double offset = 0;  // from the plain mean, to keep digits
    double leakage = 0;
    double own = 0;  // variance of the mean by the deviations of the windows, times weights^2
    for (const Block& b : blocks_) {
        weights += weight(b);
        offset += weight(b) * (b.mean - mean_);
        leakage += weight(b) * b.leakage / b.count;
        own += weight(b) * weight(b) * b.variance / (b.count * b.count);
    }
    summary.mean_f_hz = mean_ + offset / weights;
    summary.leakage_f_hz = std::abs(leakage / weights);
    if (count_ < 2) {
        return summary;
    }
    double variance = 0;
    if (blocks_.size() >= least_blocks) {
        double steps = 0;  // in units of 1/weight
        for (std::size_t i = 1; i < blocks_.size(); ++i) {
            const double step = blocks_[i].mean - blocks_[i - 1].mean;
            steps += step * step / (1 / weight(blocks_[i - 1]) + 1 / weight(blocks_[i]));
        }
        variance = steps / static_cast<double>(blocks_.size() - 1) / weights;
    } else {
        variance = spread_ / (count_ - 1) / (count_ * independent_);
        if (weighted) {
            variance = std::max(variance, own / (weights * weights) / independent_);
        }
    }
    const double hidden = (below_.count * summary.mean_f_hz - below_.sum + above_.sum -
                           above_.count * summary.mean_f_hz) /
                          (count_ + below_.count + above_.count);
    summary.scatter_f_hz = std::sqrt(variance);
    summary.sd_mean_f_hz =
        std::sqrt(variance + summary.leakage_f_hz * summary.leakage_f_hz + hidden * hidden);
    return summary;
}

TrackSummary summarise(const Track& track, double independent) {
    TrackSummariser summariser(track.rows(), independent);
    summariser.take(track);
    return summariser.summary();
}

}  // namespace vybeg
