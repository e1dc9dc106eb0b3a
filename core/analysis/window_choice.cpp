#include "core/analysis/window_choice.h"

#include "core/base/number_text.h"
#include "core/recording/checks/recording_check.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg {

std::int64_t least_phasor_window(double f0_hz, double rate_hz) {
    return std::max<std::int64_t>(16, static_cast<std::int64_t>(std::ceil(2 * rate_hz / f0_hz)));
}

std::int64_t default_phasor_window(std::int64_t frames, double f0_hz, double rate_hz) {
    constexpr double wish_s = 0.015;
    constexpr double periods = 12;
    const auto wish =
        static_cast<std::int64_t>(std::llround(std::max(wish_s, periods / f0_hz) * rate_hz));
    return std::max(
        {std::min(wish, frames / 64), frames / 16384 + 1, least_phasor_window(f0_hz, rate_hz)});
}

namespace {

// Revolutions of a mode's phasor in a window: where the program chooses, and the engineer.
constexpr double most_turn = 0.1;
constexpr double most_chosen_turn = 0.25;

struct Length {
    std::int64_t samples = 0;
    bool chosen = false;  // by the engineer
};

Result<Length> wished_length(const PhasorWindowSettings& wished,
                             const ConditionedRecording& prepared, double rate_hz) {
    Length length;
    if (wished.periods) {
        length = {window_of_periods(*wished.periods, prepared.f0_hz, rate_hz), true};
    } else if (wished.window) {
        length = {*wished.window, true};
    } else {
        length.samples =
            default_phasor_window(prepared.end - prepared.first, prepared.f0_hz, rate_hz);
    }
    const std::int64_t least = least_phasor_window(prepared.f0_hz, rate_hz);
    if (length.samples < least) {
        return Error{
            ErrorCode::fit_window_too_short, "", {count_arg(length.samples), count_arg(least)}};
    }
    return length;
}

// How far the farther of the outer lines lies from a frequency, Hz.
double farthest(const CarrierLines& lines, double f_hz) {
    return std::max(std::abs(lines.lowest_hz - f_hz), std::abs(lines.highest_hz - f_hz));
}

// The window in which lines `away` from the reference turn by no more than they may.
Result<std::int64_t> slow_enough(const Length& wish, const CarrierLines& lines, double reference_hz,
                                 double rate_hz) {
    const double away = farthest(lines, reference_hz);
    const double most = wish.chosen ? most_chosen_turn : most_turn;
    if (away * static_cast<double>(wish.samples) <= most * rate_hz) {
        return wish.samples;
    }
    const auto fitting = static_cast<std::int64_t>(most * rate_hz / away);
    const std::int64_t least = least_phasor_window(reference_hz, rate_hz);
    const std::string low = short_text(lines.lowest_hz);
    const std::string high = short_text(lines.highest_hz);
    if (fitting < least) {
        return Error{ErrorCode::fit_beat_too_fast, "", {low, high, count_arg(least)}};
    }
    if (wish.chosen) {
        return Error{ErrorCode::fit_window_turns,
                     "",
                     {count_arg(wish.samples), low, high, count_arg(fitting)}};
    }
    return fitting;
}

// The same recording, prepared at another carrier without looking for anything again.
Result<ConditionedRecording> prepared_at(double f_hz, const ConditionedRecording& before,
                                         const Recording& recording, SignalSettings settings,
                                         const JobControl& job) {
    settings.f0_hz = f_hz;
    settings.calibration = before.calibration;
    Result<ConditionedRecording> prepared = prepare(recording, settings, job);
    if (prepared) {
        prepared->carrier_s += before.carrier_s;
    }
    return prepared;
}

}  // namespace

Result<WindowChoice> choose_windows(const Recording& recording, const SignalSettings& settings,
                                    const PhasorWindowSettings& wished, const JobControl& job) {
    const double rate = recording.rate_hz;
    auto prepared = TRY(prepare(recording, settings, job));
    const auto wish = TRY(wished_length(wished, prepared, rate));
    const double begun = job.now();
    auto lines = TRY(carrier_lines(prepared, settings, wish.samples, rate, job));
    prepared.carrier_s += job.now() - begun;
    const double given = prepared.f0_hz;
    const double turn = farthest(lines, given) * static_cast<double>(wish.samples) / rate;
    if (turn > most_turn) {
        auto moved = TRY(prepared_at((lines.lowest_hz + lines.highest_hz) / 2, prepared, recording,
                                     settings, job));
        prepared = std::move(moved);
    }
    auto length = TRY(slow_enough(wish, lines, prepared.f0_hz, rate));
    if (wished.snap) {
        length = snap_window(length, prepared.f0_hz, rate);
    }
    const double lobe_hz = rate / static_cast<double>(wish.samples);
    if (settings.f0_hz && std::abs(lines.strongest_hz - given) > lobe_hz) {
        prepared.diagnostics.push_back({DiagnosticKind::carrier_elsewhere,
                                        {number_arg(given), number_arg(lines.strongest_hz)}});
    }
    const auto start = TRY(start_findings(*recording.source, rate, prepared.f0_hz));
    add_findings(start, prepared.diagnostics);
    WindowChoice choice;
    choice.plan = plan_windows(prepared.first, prepared.end, length, length);
    if (choice.plan.count == 0) {
        return Error{ErrorCode::window_too_long,
                     "",
                     {count_arg(length), count_arg(prepared.end - prepared.first)}};
    }
    choice.prepared = std::move(prepared);
    choice.lines = std::move(lines);
    return choice;
}

}  // namespace vybeg
