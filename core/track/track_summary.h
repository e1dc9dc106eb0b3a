#pragma once

#include "core/track/track.h"

#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// Summary of a whole track.
struct TrackSummary {
    std::size_t windows = 0;
    std::size_t flagged = 0;  // windows with a reason other than no_quadrature
    std::size_t at_bound = 0;
    std::size_t leaking = 0;  // with Flag::leakage
    double mean_f_hz = 0;     // weighted mean of the valid windows; NaN where there is none
    double sd_mean_f_hz = 0;  // all contributions; NaN for fewer than two windows
    // Instant of the mean, s from the start of the recording: the mean of the windows' times with
    // the same weights. A frequency that drifts evenly has the mean's value there.
    double mean_at_s = 0;
    double leakage_f_hz = 0;  // part due to leakage of a closed form: |its weighted mean|
    double scatter_f_hz = 0;  // part due to the scatter of the windows
    // Per sample and channel, root of the mean square over the windows without faults, or over all
    // where there are none; NaN: no window has one.
    double noise = 0;

    // Whether leakage, not noise, dominates the error of the mean. A window of whole half-periods
    // avoids it.
    bool leakage_limits() const { return leakage_f_hz > scatter_f_hz; }
};

// Computes the summary of a track that arrives in pieces.
//
// The mean of f is that of blocks of windows, weighted by 1/variance of a block's mean, from the
// deviations of its windows and the correlation of their errors. Windows without a value, over
// faults, not converged or at the bound of the search are excluded. Its variance is the sum of
//   - that of the weighted mean, by the deviations and correlations. Errors of windows that overlap
//     or follow a band-pass cancel each other from window to window, which no scatter of
//     blocks shows;
//   - what the second differences of the blocks' means have beyond that, as noise between blocks:
//     coloured noise counts, an even drift does not. With fewer than 20 blocks the variance grows
//     in their ratio;
//   - the squared mean of the leakage, which is common to all windows;
//   - the effect of the windows at the bound: the squared sum of their distances from the mean,
//     by the number of windows.
// Without deviations (a track without noise), the scatter about the mean replaces the first two.
class TrackSummariser {
public:
    // `rows`: their total number. `independent`: fraction of a window's samples that the next
    // window does not share, hop / length, at most 1, because overlapping windows determine the
    // mean less than their number suggests. `correlation`: of the errors of f of two windows, by
    // the hops between them, from 1 to where it stays zero; empty: that of white noise.
    TrackSummariser(std::size_t rows, double independent, std::vector<double> correlation = {});

    void take(const Track& next_rows);
    TrackSummary summary() const;

private:
    struct Block {
        double count = 0;
        double mean = 0;      // of f
        double time_s = 0;    // mean
        double variance = 0;  // sum of sd^2
        double leakage = 0;   // sum
    };
    struct Sum {
        double count = 0;
        double sum = 0;

        void take(double value) {
            count += 1;
            sum += value;
        }
    };

    void take_frequency(double time_s, double f, double sd, double leakage);
    double variance_of(const Block& block) const;
    double covariance_of(const Block& block, const Block& next) const;
    double excess(std::span<const double> variances, std::span<const double> covariances) const;

    double independent_;
    std::vector<double> correlation_;
    double block_length_;
    TrackSummary counts_;
    std::vector<Block> blocks_;
    double count_ = 0;  // Welford's recurrence over all windows
    double mean_ = 0;
    double spread_ = 0;
    std::vector<double> at_bound_;  // f of windows at the bound before the first sound one
    Sum below_;                     // of those since then, on one side of the mean
    Sum above_;
    Sum noise_;  // squares
    Sum noise_of_invalid_;
};

// Correlation of the errors of f in white noise of windows that share samples, by hops;
// `independent`: hop / length. The error of f is the noise weighted with a straight line, hence 1 -
// 3 x + 2 x^3 at a distance of x lengths.
std::vector<double> overlap_correlation(double independent);

// A whole track at once.
TrackSummary summarise(const Track& track, double independent,
                       std::vector<double> correlation = {});

}  // namespace vybeg
