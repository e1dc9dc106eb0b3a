#include "core/sweep/neighbour_scatter.h"

#include "core/estimators/wave/wave_formulas.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

constexpr std::size_t most_groups = std::size_t{1} << 16;
constexpr std::size_t least_groups = 8;
constexpr std::size_t middle = 3;
constexpr std::array<double, 7> sixth_difference{1, -6, 15, -20, 15, -6, 1};
constexpr double sixth_norm = 924;                    // sum of the squares of these
constexpr double second_norm = 6;                     // of 1, -2, 1
constexpr double normal_median = 0.6744897501960817;  // of |x|, x normal with sd 1
constexpr double far_out = 4;                         // sd of a value that does not count
// A beat moves a_B and the angles to first order, a_A and f to second: so much of the slope reaches
// them in simulated beats (0.1 to 0.4).
constexpr double second_order = 0.25;
constexpr double nan = SweepValue::none;

bool of_amplitude_or_rate(SlowVariable variable) {
    return variable == SlowVariable::a_A || variable == SlowVariable::f;
}

// Above this the absolute value of a number does not count.
double limit_of(const std::vector<double>& x) {
    std::vector<double> sizes(x.size());
    std::ranges::transform(x, sizes.begin(), [](double value) { return std::abs(value); });
    return far_out * median(std::move(sizes)) / normal_median;
}

// Root of the mean square of the values of x at which |by| lies within the limit of `by`.
double root_mean_square(const std::vector<double>& x, const std::vector<double>& by) {
    const double limit = limit_of(by);
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (std::abs(by[k]) <= limit) {
            sum += x[k] * x[k];
            ++count;
        }
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : nan;
}

// Relative standard deviation of the root mean square of sixth differences of white noise, `count`
// of them, `stride` windows apart: their squares have the correlation rho^2.
double relative_sd(std::size_t count, std::size_t stride) {
    double correlated = 1;
    for (std::size_t lag = stride; lag < sixth_difference.size(); lag += stride) {
        double product = 0;
        for (std::size_t k = 0; k + lag < sixth_difference.size(); ++k) {
            product += sixth_difference[k] * sixth_difference[k + lag];
        }
        correlated += 2 * (product / sixth_norm) * (product / sixth_norm);
    }
    return std::sqrt(correlated / (2 * static_cast<double>(count)));
}

}  // namespace

NeighbourScatter::NeighbourScatter(const WindowPlan& plan, double rate_hz, double angle_zero,
                                   std::vector<FlaggedRows> faults, const EquivalentNoise& noise)
    : plan_(plan),
      rate_hz_(rate_hz),
      angle_zero_(angle_zero),
      faults_(std::move(faults)),
      noise_(noise),
      stride_((static_cast<std::size_t>(plan.count) + most_groups - 1) / most_groups) {}

// Rows are asked in ascending order.
bool NeighbourScatter::over_fault(std::size_t row) {
    while (next_fault_ < faults_.size() &&
           row >= faults_[next_fault_].first + faults_[next_fault_].count) {
        ++next_fault_;
    }
    for (std::size_t k = next_fault_; k < faults_.size() && faults_[k].first <= row; ++k) {
        if (row < faults_[k].first + faults_[k].count) {
            return true;
        }
    }
    return false;
}

NeighbourScatter::Row NeighbourScatter::row_of(const Track& track, std::size_t k) {
    Row row;
    for (std::size_t v = 0; v < sweep_variable_count; ++v) {
        row.values[v] = track.values(main_slow_variables[v])[k];
        row.sds[v] = track.sds(main_slow_variables[v])[k];
    }
    row.alpha = track.values(SlowVariable::alpha)[k];
    row.counts = is_sound_window(track.flags()[k]) && !over_fault(rows_);
    return row;
}

void NeighbourScatter::take(const Track& next_rows) {
    for (std::size_t k = 0; k < next_rows.rows(); ++k) {
        std::shift_left(held_.begin(), held_.end(), 1);
        held_.back() = row_of(next_rows, k);
        const double rms = next_rows.values(SlowVariable::rms)[k];
        const double noise = next_rows.values(SlowVariable::noise)[k];
        if (held_.back().counts && std::isfinite(rms)) {
            rms_squares_ += rms * rms;
            noise_squares_ += noise * noise;
            ++used_;
        }
        ++rows_;
        if (rows_ >= held_rows && rows_ % stride_ == 0) {
            judge_middle();
        }
    }
}

void NeighbourScatter::judge_middle() {
    if (!std::ranges::all_of(held_, &Row::counts)) {
        return;
    }
    const Row& at = held_[middle];
    const double a_B = std::isnan(at.values[1]) ? 0 : at.values[1];  // algorithm 1 has none
    const WaveState state{at.values[0], a_B, at.values[2] + angle_zero_, at.alpha};
    const WaveErrors unit =
        precision_bound(to_phasors(state), at.values[3], rate_hz_, plan_.length, 1);
    const std::array bounds{unit.a_A, unit.a_B, unit.two_theta_A, unit.f_hz, unit.delta_phi_CD};
    for (std::size_t v = 0; v < sweep_variable_count; ++v) {
        const double period =
            main_slow_variables[v] == SlowVariable::delta_phi_CD ? 2 * std::numbers::pi : 0;
        double sixth = 0;
        std::array<double, held_rows> x{};
        for (std::size_t k = 0; k < held_rows; ++k) {
            x[k] = held_[k].values[v];
            if (period > 0 && k > 0) {
                x[k] = x[k - 1] + std::remainder(x[k] - x[k - 1], period);
            }
            sixth += sixth_difference[k] * x[k];
        }
        const double bound = bounds[v];
        if (std::isfinite(sixth) && std::isfinite(bound) && bound > 0) {
            Sums& sums = sums_[v];
            sums.sixth.push_back(sixth / (std::sqrt(sixth_norm) * bound));
            sums.second.push_back((x[middle - 1] - 2 * x[middle] + x[middle + 1]) / bound);
            sums.stated.push_back(at.sds[v] / bound);
            sums.bound.push_back(bound);
        }
    }
}

SweepLength NeighbourScatter::finish() const {
    SweepLength found;
    found.length = plan_.length;
    found.windows = plan_.count;
    found.used = used_;
    if (used_ > 0) {
        found.rms = std::sqrt(rms_squares_ / static_cast<double>(used_));
        found.noise = std::sqrt(noise_squares_ / static_cast<double>(used_));
    }
    const double white = noise_.phasors;
    const double beyond = std::sqrt(std::max(found.noise * found.noise - white * white, 0.0));
    for (std::size_t v = 0; v < sweep_variable_count; ++v) {
        const Sums& sums = sums_[v];
        if (sums.sixth.size() < least_groups) {
            continue;
        }
        SweepValue& value = found.values[v];
        const double typical = median(sums.bound);
        const bool of_frequency = main_slow_variables[v] == SlowVariable::f;
        value.bound = typical * (of_frequency ? noise_.frequency : noise_.phasors);
        const double scatter = root_mean_square(sums.sixth, sums.sixth);
        const double second = root_mean_square(sums.second, sums.sixth);
        value.scatter = typical * scatter;
        value.sd_scatter = value.scatter * relative_sd(sums.sixth.size(), stride_);
        value.stated = typical * root_mean_square(sums.stated, sums.stated);
        const double bend = second * second - second_norm * scatter * scatter;
        value.motion = typical * std::sqrt(std::max(bend, 0.0)) / 24;
        // A slope d in the window enters the projections through their residual, about d/2n.
        const double share = of_amplitude_or_rate(main_slow_variables[v]) ? second_order : 1;
        value.unmodelled =
            share * typical * beyond * std::sqrt(3 / static_cast<double>(plan_.length));
    }
    return found;
}

}  // namespace vybeg
