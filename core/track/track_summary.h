#pragma once

#include "core/track/track.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace vybeg {

// Summary of a whole track.
struct TrackSummary {
    std::size_t windows = 0;
    std::size_t flagged = 0;  // windows with a reason other than no_quadrature
    std::size_t at_bound = 0;
    std::size_t leaking = 0;  // with Flag::leakage
    std::size_t moving = 0;   // with Flag::moving
    double mean_f_hz = 0;     // weighted mean of the valid windows; NaN where there is none
    double sd_mean_f_hz = 0;  // all contributions; NaN for fewer than two windows
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
// The mean of f is weighted with 1/sd^2, averaged over a block of windows, because the deviation of
// a single short window is itself known to no more than a third. Windows without a value, over
// faults, not converged or at the bound of the search are excluded. Its variance is the sum of
//   - the scatter of the block means: half of their mean squared step from block to block, so that
//     a drift of the frequency is no scatter, while overlapping windows and noise correlated over
//     some windows count; with fewer than 20 blocks that of the windows about the mean, but no
//     less than their own deviations;
//   - the squared mean of the leakage, which is common to all windows;
//   - the effect of the windows at the bound: the squared sum of their distances from the mean,
//     by the number of windows.
class TrackSummariser {
public:
    // `rows`: their total number. `independent`: fraction of a window's samples that the next
    // window does not share, hop / length, at most 1, because overlapping windows determine the
    // mean less than their number suggests.
    TrackSummariser(std::size_t rows, double independent);

    void take(const Track& next_rows);
    TrackSummary summary() const;

private:
    struct Block {
        double count = 0;
        double mean = 0;      // of f
        double variance = 0;  // sum of sd^2
        double leakage = 0;   // sum
    };
    struct Beyond {  // windows at the bound on one side
        double count = 0;
        double sum = 0;  // of f
    };

    struct MeanSquare {
        double count = 0;
        double sum = 0;
        void take(double value) {
            count += 1;
            sum += value * value;
        }
        double root() const { return std::sqrt(sum / count); }  // NaN for none
    };

    void take_frequency(double f, double sd, double leakage);

    double independent_;
    double block_length_;
    TrackSummary counts_;
    std::vector<Block> blocks_;
    double count_ = 0;  // Welford's recurrence over all windows
    double mean_ = 0;
    double spread_ = 0;
    Beyond below_;
    Beyond above_;
    MeanSquare noise_;
    MeanSquare noise_of_invalid_;
};

// A whole track at once.
TrackSummary summarise(const Track& track, double independent);

}  // namespace vybeg
