#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// Control charts of a series of single results (NIST/SEMATECH e-Handbook of Statistical Methods,
// 6.3.2; D. C. Montgomery, Introduction to Statistical Quality Control). The first `baseline`
// results set the centre and the limits; a value that is NaN is no point and counts in neither.

// Individuals and moving range: unit of the values. Centre +- 2.66 mean ranges, 3.267 mean ranges.
struct IndividualsChart {
    double centre = 0;  // this and the limits: NaN with fewer than two values in the baseline
    double low = 0;
    double high = 0;
    double mean_range = 0;
    double range_limit = 0;
    std::vector<double> ranges;      // |change from the value before|; NaN for the first
    std::vector<bool> out;           // of each value: beyond the limits
    std::vector<bool> range_is_out;  // of each range
};

IndividualsChart individuals_chart(std::span<const double> values, std::size_t baseline);

struct EwmaOptions {
    double lambda = 0.2;
    // Points for each false alarm at a stable resonator, on average over baselines. Above 370,
    // which a chart by three deviations has.
    double points_per_alarm = 450;
};

// Exponentially weighted moving average of z = (value - centre) / sqrt(scatter^2 + sd^2), in
// deviations: results with large deviations of their own weigh no more than others.
struct EwmaChart {
    double centre = 0;   // mean of the baseline, weighted by 1 / (scatter^2 + sd^2)
    double scatter = 0;  // between the baseline's results, beyond their own deviations
    double limit = 0;    // ewma_limit(); NaN: the baseline is too short for one
    std::vector<double> z;
    std::vector<double> average;
    std::vector<double> limits;  // +-, of each average; they widen over the first points
    std::vector<bool> out;
};

// `sd`: each result's own standard deviation, NaN or 0: not known. Preconditions: as many as
// values; 0 < lambda <= 1.
EwmaChart ewma_chart(std::span<const double> values, std::span<const double> sd,
                     std::size_t baseline, const EwmaOptions& options = {});

// Axes that repeat with `period`, each moved by whole periods to the nearest of the first one, so
// that a series near the end of the range does not jump. A period of 0 leaves the values.
std::vector<double> beside_first(std::span<const double> values, double period);

}  // namespace vybeg
