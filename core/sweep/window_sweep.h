#pragma once

#include "core/analysis/settings.h"
#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"
#include "core/track/track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// The variables of a sweep: main_slow_variables, in that order.
inline constexpr std::size_t sweep_variable_count = main_slow_variables.size();

// Algorithms 1 to 4, whose closed forms presume whole half-periods.
inline constexpr std::array<Algorithm, 4> closed_form_algorithms{
    Algorithm::in_phase, Algorithm::phase_shift, Algorithm::moving_axes, Algorithm::demodulation};

// One variable in windows of one length: standard deviations of a typical window, in the unit of
// the stored values (track.h). NaN where the variable or the value does not exist.
struct SweepValue {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    double scatter = none;     // between neighbouring windows, less the slow motion
    double sd_scatter = none;  // of it
    double stated = none;      // by the windows themselves
    double bound = none;       // Cramer-Rao bound for the white noise of the recording
    double motion = none;      // x'' T^2/24: the shift of a window's mean by the bend inside it
    double unmodelled = none;  // what the residual beyond the white noise leaks into the window
    double leaking = 0;        // leakage of the algorithm of the sweep; 0 for 5 and 6
    std::array<double, closed_form_algorithms.size()> leakage{none, none, none, none};

    // Expected rms error. Leakage is in the scatter, too, unless it is common to neighbours.
    double error() const {
        return std::hypot(std::max({scatter, bound, leaking}), motion, unmodelled);
    }
};

struct SweepLength {
    std::int64_t length = 0;          // samples
    std::int64_t windows = 0;         // one after the other
    std::int64_t used = 0;            // of these, not over faults of the samples, converged
    std::int64_t moving = 0;          // those that an analysis flags, and warns of (Flag::moving)
    double rms = SweepValue::none;    // of the residual, root of the mean square, recording units
    double noise = SweepValue::none;  // per sample, from that residual
    std::array<SweepValue, sweep_variable_count> values;
};

// The recommended window, and why.
struct WindowAdvice {
    enum class Limit {
        motion,      // longer windows blur `variable`
        scatter,     // longer windows scatter more: leakage or noise that is not white
        flat,        // longer windows are better by less than a quarter
        no_values,   // in the next longer windows a variable has no value
        list_end,    // the longest of the list: even there nothing moves inside a window
        list_begin,  // the shortest of the list, and `variable` moves inside it
    };
    std::size_t best = 0;      // index into WindowSweep::lengths
    std::size_t shortest = 0;  // from here to `longest` no loss is above `loss_span` times the best
    std::size_t longest = 0;
    Limit limit = Limit::list_end;
    std::size_t variable = 0;  // the one that motion or scatter worsens most in the next window
    double loss = 1;           // largest ratio of an error to its least in the list, at `best`
    std::size_t loser = 0;     // the variable of that ratio
    // Where windows of `best` are flagged as moving: the best length without such windows, and its
    // loss over that of `best`.
    std::optional<std::size_t> quiet = std::nullopt;
    double quiet_loss = 1;
};
inline constexpr double loss_span = 1.5;

struct WindowSweep {
    struct Refused {
        std::int64_t length = 0;
        Error error;
    };
    Settings settings;  // as used, without a window
    double rate_hz = 0;
    double f0_hz = 0;
    double white_noise = SweepValue::none;  // sd per sample and channel, recording units
    std::vector<SweepLength> lengths;       // ascending
    std::vector<Refused> refused;
    std::optional<WindowAdvice> advice;  // none where fewer than two lengths have errors
};

// The length at which the largest loss is least. The loss of a variable is its expected error
// (SweepValue::error()) over the least one in the list: errors of different units become
// comparable, and no variable is sacrificed. Of lengths of nearly the same loss it is the shortest,
// and one without windows that an analysis flags as moving goes before one of half the loss.
// A variable that has no error in most lengths does not count, nor a length in which another
// variable has none. `lengths` ascend. Nothing for fewer than two lengths.
std::optional<WindowAdvice> advise_window(std::span<const SweepLength> lengths);

// 15 whole numbers from `first` to `last` in about equal ratios, ascending, each once: fewer where
// they lie close. Precondition: 1 <= first <= last.
std::vector<std::int64_t> spaced_lengths(std::int64_t first, std::int64_t last);

// The algorithm of the settings in adjacent windows of each length; with `snap` each is moved to
// whole half-periods. The settings' window, periods and hop do not count. One preparation serves
// all lengths; up to 2^24 frames are held in memory, more are read again for each length. The
// result is the same to the last bit for any number of threads. Errors: setting_invalid, those of
// prepare() and of the source; that of a length where no length of the list is possible;
// interrupted.
Result<WindowSweep> sweep_windows(const Recording& recording, const Settings& settings,
                                  std::span<const std::int64_t> lengths, const JobControl& job);

}  // namespace vybeg
