#include "core/resonator/runs/mode_beat.h"

#include "core/estimators/wave/wave_state.h"
#include "core/numerics/minimise.h"
#include "core/resonator/runs/merge_windows.h"
#include "core/track/trend.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

constexpr std::size_t merged_windows = 150;
constexpr double beyond_noise = 3;    // standard deviations of chi^2 per degree of freedom
constexpr double clear_beat = 6;      // standard deviations
constexpr double white = 1.5;         // correlated windows
constexpr double most_scatter = 100;  // chi^2 per degree of freedom
constexpr std::size_t turned_windows = 2400;

PhasorRun phasors_between(const Track& track, double f_ref_hz, double from_s, double to_s,
                          std::size_t apart) {
    PhasorRun run;
    run.f_ref_hz = f_ref_hz;
    const auto value = [&track](SlowVariable variable, std::size_t k) {
        return track.values(variable)[k];
    };
    const auto times = track.time_s();
    for (std::size_t k =
             static_cast<std::size_t>(std::ranges::lower_bound(times, from_s) - times.begin());
         k < times.size() && times[k] <= to_s;) {
        const Phasors phasors =
            to_phasors({value(SlowVariable::a_A, k), value(SlowVariable::a_B, k),
                        value(SlowVariable::two_theta_A, k), value(SlowVariable::alpha, k)});
        const double sd = track.sds(SlowVariable::a_A)[k];
        if (!is_sound_window(track.flags()[k]) || !std::isfinite(std::abs(phasors.c)) ||
            !(sd > 0)) {
            ++k;
            continue;
        }
        const std::complex<double> back =
            std::polar(1., -2 * std::numbers::pi * std::remainder(f_ref_hz * times[k], 1));
        run.time_s.push_back(times[k]);
        run.c.push_back(back * phasors.c);
        run.d.push_back(back * phasors.d);
        run.sd.push_back(sd);
        k += apart;
    }
    // Windows that count follow each other at least so far apart.
    run.window_s = times.size() > apart ? times[apart] - times[0] : 0;
    return run;
}

// What remains of a mode in the mean over `count` windows.
std::complex<double> merged_share(std::complex<double> rate, double window_s, double count) {
    const std::complex<double> half = 0.5 * window_s * rate;
    return std::abs(half) > 0 ? std::sinh(count * half) / (count * std::sinh(half)) : 1;
}

struct DriftingModes {
    double drift_hz_s = 0;
    double from_s = 0;    // centre of the first merged window
    double window_s = 0;  // merged
    std::optional<ModeSum> sum;

    double excess() const {
        return sum ? sum->chi2 - sum->freedom : std::numeric_limits<double>::infinity();
    }
    bool is_noise() const { return sum && excess() < beyond_noise * std::sqrt(2 * sum->freedom); }
    // White scatter of the windows, beyond their deviations: the carrier's phase in windows of a
    // fast beat.
    bool is_white() const {
        return sum && sum->correlated_windows < white && sum->chi2 < most_scatter * sum->freedom;
    }
};

DriftingModes modes_with(const PhasorRun& run, double drift_hz_s) {
    PhasorRun turned = run;
    const double centre_s = 0.5 * (run.time_s.front() + run.time_s.back());
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const double u = run.time_s[k] - centre_s;
        const std::complex<double> back = std::polar(1., -std::numbers::pi * drift_hz_s * u * u);
        turned.c[k] *= back;
        turned.d[k] *= back;
    }
    turned = merge_windows(turned, merged_windows);
    return {drift_hz_s, turned.time_s.front(), turned.window_s, sum_of_modes(turned, 2)};
}

// Two modes; where they leave more than noise, with the drift that leaves least.
DriftingModes fitted_modes(const PhasorRun& run, double drift_hz_s) {
    constexpr double most_steps = 20;
    constexpr double exact = 1e-5;
    DriftingModes still = modes_with(run, 0);
    if (still.is_noise()) {
        return still;
    }
    // Turns both ends by half a radian.
    const double span = run.time_s.back() - run.time_s.front();
    const double step = 2 / (std::numbers::pi * span * span);
    const Minimum least = minimise([&run](double drift) { return modes_with(run, drift).excess(); },
                                   drift_hz_s - most_steps * step, drift_hz_s,
                                   drift_hz_s + most_steps * step, step, exact * step);
    return least.value < still.excess() ? modes_with(run, least.at) : still;
}

}  // namespace

double ModeBeat::at(SlowVariable variable, double time_s) const {
    Eigen::Vector2cd z = Eigen::Vector2cd::Zero();
    Eigen::Vector2cd change = Eigen::Vector2cd::Zero();  // per second
    for (std::size_t mode = 0; mode < modes.rates.size(); ++mode) {
        const std::complex<double> rate = modes.rates[mode];
        const Eigen::Vector2cd now = std::exp(rate * (time_s - from_s)) * modes.shapes[mode];
        z += now;
        change += rate * now;
    }
    const WaveState wave = to_wave_state({z[0], z[1]});
    switch (variable) {
        case SlowVariable::a_A: return wave.a_A;
        case SlowVariable::a_B: return wave.a_B;
        case SlowVariable::two_theta_A: return wave.two_theta_A;
        case SlowVariable::f:
            return f_ref_hz + drift_hz_s * (time_s - centre_s) +
                   z.dot(change).imag() / (2 * std::numbers::pi * z.squaredNorm());
        default: turn_channels(-two_theta_zero, z[0], z[1]); return phase_difference({z[0], z[1]});
    }
}

std::optional<ModeBeat> find_mode_beat(const Track& track, double f_ref_hz, double two_theta_zero,
                                       double from_s, double to_s, std::size_t apart) {
    const PhasorRun fine = phasors_between(track, f_ref_hz, from_s, to_s, apart);
    const auto drift = line_trend(track, SlowVariable::f, from_s, to_s, apart);
    if (fine.time_s.size() < 2 || !drift) {
        return {};
    }
    const PhasorRun run = merge_windows(fine, turned_windows);
    DriftingModes found = fitted_modes(run, drift->slope_per_s);
    if (!found.is_noise() && !found.is_white()) {
        return {};
    }
    const double first_s = run.time_s.front();
    const double last_s = run.time_s.back();
    const double merged = std::round(found.window_s / fine.window_s);
    const double turn = 2 * std::numbers::pi;
    ModeBeat beat;
    beat.modes = std::move(*found.sum);
    beat.from_s = found.from_s;
    beat.centre_s = 0.5 * (first_s + last_s);
    beat.f_ref_hz = f_ref_hz;
    beat.drift_hz_s = found.drift_hz_s;
    beat.two_theta_zero = two_theta_zero;
    beat.frequency_hz = (beat.modes.rates[0] - beat.modes.rates[1]).imag() / turn;
    beat.sd_frequency_hz = beat.modes.beat_sd / turn;
    for (std::size_t mode = 0; mode < beat.modes.rates.size(); ++mode) {
        beat.modes.shapes[mode] /= merged_share(beat.modes.rates[mode], fine.window_s, merged);
    }
    const bool is_beat = beat.frequency_hz * (last_s - first_s) >= least_beat_periods &&
                         beat.frequency_hz > clear_beat * beat.sd_frequency_hz &&
                         std::ranges::max(beat.modes.shape_sd) < 1 / clear_beat;
    return is_beat ? std::optional(std::move(beat)) : std::nullopt;
}

}  // namespace vybeg
