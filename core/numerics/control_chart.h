#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace vybeg {

// Probability that a number of Student's distribution with `freedom` degrees of freedom lies beyond
// +-t. Finite series for whole degrees (M. Abramowitz, I. A. Stegun, 26.7.3 and 26.7.4).
// Preconditions: t >= 0, freedom >= 1.
double student_beyond(double t, std::size_t freedom);

// The t beyond which lies the probability `beyond`, on both sides together, to 1e-9 of itself.
// Preconditions: 1e-10 <= beyond < 1, freedom >= 1.
double student_limit(double beyond, std::size_t freedom);

// Control charts of a series of single results (NIST/SEMATECH e-Handbook of Statistical Methods,
// 6.3.2; D. C. Montgomery, Introduction to Statistical Quality Control). The first `baseline`
// results set the centre and the limits; a value that is NaN is no point and counts in neither.

// Usual weight of the last result in the average.
inline constexpr double last_weight = 0.2;

// One chart: a number for each result, its limit, and whether it lies beyond.
struct ControlChart {
    std::vector<double> values;
    std::vector<double> limits;  // NaN: the baseline sets none
    std::vector<bool> out;
};

// What a baseline may have that limits do not allow for; the first that is found.
enum class BaselineFault {
    none,
    too_few,    // fewer than least_baseline results of equal weight, or all alike: no limits
    trend,      // it rises or falls
    correlated  // each result resembles, or opposes, the one before
};

// Chance that a stable baseline is called trending, and that it is called correlated.
inline constexpr double baseline_level = 0.005;

// Three charts with one family of limits: each has a share of the false alarms, and Student's
// distribution and ewma_limit() allow for a centre and a scatter from a baseline of finite length.
struct ControlCharts {
    double centre = std::numeric_limits<double>::quiet_NaN();  // weighted mean of the baseline
    std::size_t used = 0;  // results of equal weight that would set it as well (L. Kish)
    BaselineFault fault = BaselineFault::too_few;
    std::vector<double> deviations;  // expected of each value about the centre
    ControlChart individuals;        // value - centre
    ControlChart ranges;             // |change from the value before|; NaN for the first
    ControlChart average;            // exponentially weighted, of the deviations in their units

    // Beyond a limit of any chart.
    bool is_out(std::size_t point) const {
        return individuals.out[point] || ranges.out[point] || average.out[point];
    }
};

// `u`: each result's own standard uncertainty; NaN or 0: not known. A result weighs less where its
// u is larger. The scatter of the baseline decides how large a deviation is expected: where it is
// above u, results differ by more than their u (R. C. Paule, J. Mandel, 1982); where it is below,
// u holds parts that all results share, such as those of the channels. `lambda`: weight of the last
// result in the average. Preconditions: as many as values; 0 < lambda <= 1.
ControlCharts control_charts(std::span<const double> values, std::span<const double> u,
                             std::size_t baseline, double lambda = last_weight);

// Axes that repeat with `period`, each moved by whole periods to the nearest of the first one, so
// that a series near the end of the range does not jump. A period of 0 leaves the values.
std::vector<double> beside_first(std::span<const double> values, double period);

// Mean number of independent normal numbers z (mean `shift`, standard deviation `sd`) until the
// exponentially weighted mean E = lambda z + (1 - lambda) E, from E = 0, leaves
// +-limit sqrt(lambda / (2 - lambda)). Integral equation of S. V. Crowder, Technometrics 29 (1987)
// 401-407, by Gauss-Legendre quadrature. Preconditions: 0 < lambda <= 1, limit > 0, sd > 0.
double ewma_run_length(double lambda, double limit, double shift, double sd);

// The limit at which a chart whose centre and standard deviation come from `baseline` normal
// numbers gives one false alarm in `points_per_alarm` points: 1/ewma_run_length() averaged over the
// errors of both (L. A. Jones, C. W. Champ, S. E. Rigdon, Technometrics 43 (2001) 156-167). Widens
// as the baseline shortens. NaN below least_baseline.
double ewma_limit(double lambda, std::size_t baseline, double points_per_alarm);

// Shortest baseline of a chart.
inline constexpr std::size_t least_baseline = 10;

}  // namespace vybeg
