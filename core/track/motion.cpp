#include "core/track/motion.h"

#include "core/estimators/wave/window_moments.h"
#include "core/numerics/phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace vybeg {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double quarter = pi / 4;
// Rounding of an estimate without noise.
constexpr double rounding = 1e-9;
// Standard deviations of the bend's noise that a bend has to exceed.
constexpr double rare = 5.5;
// Largest standard deviation of the predicted alpha, in half turns, at which its step is
// conclusive.
constexpr double foretold = 0.08;

// Adds rows [first, end) to ranges ordered by their ends.
void add(std::size_t first, std::size_t end, std::vector<FlaggedRows>& segments) {
    if (!segments.empty()) {
        FlaggedRows& last = segments.back();
        if (first <= last.first + last.count) {
            last.count = std::max(end, last.first + last.count) - last.first;
            return;
        }
    }
    segments.push_back({first, end - first, Flag::moving});
}

double turned(double from, double to) {
    return std::remainder(to - from, pi);
}

}  // namespace

MotionMarker::MotionMarker(std::int64_t length, std::int64_t hop, double rate_hz, double f0_hz,
                           std::span<const double> f_correlation)
    : apart_(static_cast<std::size_t>(
          std::max<std::int64_t>(1, (length + hop / 2) / std::max<std::int64_t>(hop, 1)))),
      lengths_apart_(static_cast<double>(apart_) * static_cast<double>(hop) /
                     static_cast<double>(length)),
      hop_s_(static_cast<double>(hop) / rate_hz) {
    const WindowKernel kernel = window_kernel(length, 2 * pi * f0_hz / rate_hz);
    slope_share_ = 0.5 * std::abs(kernel.slope) /
                   (std::min(kernel.gram_cos, kernel.gram_sin) * static_cast<double>(length));
    const auto correlation = [&](std::size_t hops) {
        return hops < f_correlation.size() ? f_correlation[hops] : 0;
    };
    // Errors of f alternate more than those of the phasors.
    second_variance_ = std::max(6 - 8 * correlation(apart_) + 2 * correlation(2 * apart_), 6.0);
}

MotionMarker::Row MotionMarker::row_of(const Track& track, std::size_t k, double excess) {
    // A search that ended elsewhere than at a maximum says nothing of a motion; its row is flagged.
    if (has(track.flags()[k], Flag::at_bound) || has(track.flags()[k], Flag::not_converged)) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan, nan, nan, nan, nan, nan, nan, nan, nan, nan};
    }
    const auto value = [&](SlowVariable v) { return track.values(v)[k]; };
    const auto variance = [&](SlowVariable v) {
        return excess * track.sds(v)[k] * track.sds(v)[k];
    };
    using enum SlowVariable;
    return {value(a_A),   value(a_B),    value(two_theta_A), value(alpha),          value(f),
            value(noise), variance(a_A), variance(a_B),      variance(two_theta_A), variance(alpha),
            variance(f)};
}

void MotionMarker::take(const Track& next_rows, std::span<const char> no_wave, double excess) {
    for (std::size_t k = 0; k < next_rows.rows(); ++k) {
        if (k < no_wave.size() && no_wave[k] != 0) {
            add(rows_, rows_ + 1, no_wave_);
        }
        const Row row = row_of(next_rows, k, excess);
        step_to(row);
        held_.push_back(row);
        ++rows_;
        while (judged_ + apart_ < rows_) {
            judge_next();
        }
    }
    for (; first_held_ + apart_ < judged_; ++first_held_) {
        held_.pop_front();
    }
}

void MotionMarker::judge_next() {
    const std::size_t row = judged_++;
    if (row < apart_) {
        return;
    }
    const std::size_t at = row - first_held_;
    if (bends(held_[at - apart_], held_[at], held_[at + apart_])) {
        add(row - apart_, row + apart_ + 1, inside_);
    }
}

bool MotionMarker::bends(const Row& before, const Row& at, const Row& after) const {
    const double share = 1 / (24 * lengths_apart_ * lengths_apart_);
    const double limit = std::max(0.36, rare * rare * second_variance_ * share * share);
    const auto second = [&](double Row::*value) {
        return after.*value - 2 * at.*value + before.*value;
    };
    const auto beyond = [&](double bend, double Row::*variance, double scale) {
        const double bias = std::abs(bend) * share;
        return bias * bias > limit * (before.*variance + at.*variance + after.*variance) / 3 &&
               bias > rounding * scale;
    };
    const double forward = turned(at.two_theta_A, after.two_theta_A);
    const double back = turned(before.two_theta_A, at.two_theta_A);
    if (lengths_apart_ > 1.2 && at.noise * at.noise > 0.5 * at.a_A * std::sqrt(at.var_a_A)) {
        const auto differs = [&](double bend, double Row::*variance) {
            return bend * bend >
                   6 * second_variance_ * (before.*variance + 4 * at.*variance + after.*variance);
        };
        if (differs(second(&Row::a_A), &Row::var_a_A) ||
            differs(second(&Row::a_B), &Row::var_a_B) ||
            differs(forward - back, &Row::var_two_theta_A)) {
            return true;
        }
    }
    // Steps beyond their noise; of a wave near a circle the angle alone steps far.
    const auto clear = [&](double x, double Row::*variance) {
        return x * x > rare * rare * (before.*variance + after.*variance) ? x : 0;
    };
    const double step = std::hypot(clear(after.a_A - before.a_A, &Row::var_a_A),
                                   clear(after.a_B - before.a_B, &Row::var_a_B),
                                   at.a_A * clear(forward + back, &Row::var_two_theta_A));
    const double skewed = slope_share_ * step / (2 * lengths_apart_);
    if (skewed * skewed > 0.25 * (before.var_a_A + at.var_a_A + after.var_a_A) / 3 &&
        skewed > rounding * at.a_A) {
        return true;
    }
    return beyond(second(&Row::a_A), &Row::var_a_A, at.a_A) ||
           beyond(second(&Row::a_B), &Row::var_a_B, at.a_A) ||
           beyond(forward - back, &Row::var_two_theta_A, 1) ||
           beyond(second(&Row::f_hz), &Row::var_f, at.f_hz) ||
           std::abs(forward + back) > 2 * quarter * lengths_apart_;
}

bool MotionMarker::bends_inside(const Row& window, const Track& parts) {
    constexpr double seldom = 3.5;  // of a few windows, as `rare` of many
    const auto count = static_cast<double>(parts.rows());
    // By the parabola of least squares through the parts, x'' T^2/24 is the mean with the weights
    // u^2 - <u^2>, u from -1/2 to 1/2, over 12 times the sum of their squares.
    std::vector<double> weights;
    for (std::size_t k = 0; k < parts.rows(); ++k) {
        const double u = (static_cast<double>(k) + 0.5) / count - 0.5;
        weights.push_back(u * u - (1 - 1 / (count * count)) / 12);
    }
    const double squares = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.);
    const auto beyond = [&](double Row::*value, double Row::*variance, double scale) {
        double bias = 0;
        double noise = 0;
        for (std::size_t k = 0; k < parts.rows(); ++k) {
            const double share = weights[k] / (12 * squares);
            const Row part = row_of(parts, k);
            bias += share * part.*value;
            noise += share * share * part.*variance;
        }
        return bias * bias > std::max(0.36 * window.*variance, seldom * seldom * noise) &&
               std::abs(bias) > rounding * scale;
    };
    const auto angle = parts.values(SlowVariable::two_theta_A);
    const double turn = (angle.back() - angle.front()) * count / (count - 1);
    return beyond(&Row::a_A, &Row::var_a_A, window.a_A) ||
           beyond(&Row::a_B, &Row::var_a_B, window.a_A) ||
           beyond(&Row::two_theta_A, &Row::var_two_theta_A, 1) ||
           beyond(&Row::f_hz, &Row::var_f, window.f_hz) || std::abs(turn) > quarter;
}

void MotionMarker::step_to(const Row& row) {
    if (std::isnan(row.two_theta_A)) {
        return;
    }
    if (any_valid_ &&
        loses_branch(last_valid_, row, static_cast<double>(rows_ - last_valid_row_))) {
        add(last_valid_row_, rows_ + 1, between_);
    }
    last_valid_ = row;
    last_valid_row_ = rows_;
    any_valid_ = true;
}

bool MotionMarker::loses_branch(const Row& from, const Row& to, double hops) const {
    const double step = to.two_theta_A - from.two_theta_A;
    if (std::abs(step) > quarter + 4 * std::sqrt(from.var_two_theta_A + to.var_two_theta_A)) {
        return true;
    }
    const std::optional<double> off = phase_off(from, to, hops * hop_s_);
    return off && std::abs(*off) > pi / 2;
}

std::optional<double> MotionMarker::phase_off(const Row& from, const Row& to, double seconds) {
    // The frequency of a window is the mean rate of u+ and u- weighted by their powers; with a
    // quadrature a turn of the angle adds to it.
    const double step = to.two_theta_A - from.two_theta_A;
    const double b = std::isnan(to.a_B) ? 0 : to.a_B;
    const double share = 2 * to.a_A * b / (to.a_A * to.a_A + b * b);
    const double rate = 2 * pi * seconds;  // rad per Hz
    const double variance =
        from.var_alpha + to.var_alpha + 0.25 * rate * rate * (from.var_f + to.var_f);
    if (!(variance < foretold * foretold * pi * pi) || std::abs(share) > 0.5) {
        return std::nullopt;
    }
    // In turns, of which only the fraction counts.
    const double turns = 0.5 * (from.f_hz + to.f_hz) * seconds;
    return wrap(from.alpha - to.alpha - 2 * pi * std::remainder(turns, 1.0) + step * share);
}

std::vector<FlaggedRows> MotionMarker::finish() {
    std::vector<FlaggedRows> both = inside_;
    both.insert(both.end(), between_.begin(), between_.end());
    both.insert(both.end(), no_wave_.begin(), no_wave_.end());
    std::ranges::sort(both, {}, &FlaggedRows::first);
    std::vector<FlaggedRows> found;
    for (const FlaggedRows& rows : both) {
        add(rows.first, rows.first + rows.count, found);
    }
    return found;
}

}  // namespace vybeg
