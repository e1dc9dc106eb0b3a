#include "core/resonator/runs/run_track.h"

#include "core/estimators/wave/wave_state.h"
#include "core/numerics/phase.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace vybeg {

RunTrack run_track(const PhasorRun& run, std::size_t most_points) {
    RunTrack track;
    const std::size_t windows = run.time_s.size();
    const std::size_t points = std::min(most_points, windows);
    double last_angle = 0;
    for (std::size_t point = 0; point < points; ++point) {
        const std::size_t first = point * windows / points;
        const std::size_t end = (point + 1) * windows / points;
        const auto n = static_cast<double>(end - first);
        WaveState sum;
        double time_s = 0;
        double variance = 0;
        double angle_variance = 0;
        double power = 0;
        double turns = 0;    // of the phase, relative to f_ref
        double seconds = 0;  // that they took
        for (std::size_t k = first; k < end; ++k) {
            const WaveState state = to_wave_state({run.c[k], run.d[k]});
            last_angle = nearest_branch(state.two_theta_A, k == 0 ? state.two_theta_A : last_angle,
                                        std::numbers::pi);
            const double own_power = state.a_A * state.a_A + state.a_B * state.a_B;
            const double own_variance = run.sd[k] * run.sd[k];
            const double difference = state.a_A * state.a_A - state.a_B * state.a_B;
            time_s += run.time_s[k];
            sum.a_A += state.a_A;
            sum.a_B += state.a_B;
            sum.two_theta_A += last_angle;
            variance += own_variance;
            angle_variance += own_variance * own_power / (difference * difference);
            power += own_power;
            if (k > first) {
                turns += std::arg(run.product(k - 1, k)) / (2 * std::numbers::pi);
                seconds += run.time_s[k] - run.time_s[k - 1];
            }
        }
        track.time_s.push_back(time_s / n);
        track.a_A.push_back(sum.a_A / n);
        track.a_B.push_back(sum.a_B / n);
        track.sd_a.push_back(std::sqrt(variance) / n);
        track.two_theta_A.push_back(sum.two_theta_A / n);
        track.sd_two_theta_A.push_back(std::sqrt(angle_variance) / n);
        // The sum of the phase steps is the difference of the ends, so only their noise remains.
        const double sd_phase = std::sqrt(2 * variance / power);
        const bool any = seconds > 0;
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        track.f_hz.push_back(any ? run.f_ref_hz + turns / seconds : none);
        track.sd_f_hz.push_back(any ? sd_phase / (2 * std::numbers::pi * seconds) : none);
    }
    return track;
}

ChannelBalance channel_balance(const PhasorRun& run, const FittedMotion& motion, std::size_t index,
                               std::size_t most_points) {
    ChannelBalance balance;
    const std::size_t windows = run.time_s.size();
    const std::size_t points = std::min(most_points, windows);
    const std::vector<Phasors> fitted = predicted_phasors(motion, index, run.time_s);
    for (std::size_t point = 0; point < points; ++point) {
        double count = 0;
        double time = 0;
        double sum = 0;
        double variance = 0;
        std::complex<double> direction;  // its period is 90 degrees of theta
        for (std::size_t k = point * windows / points; k < (point + 1) * windows / points; ++k) {
            const WaveState wave = to_wave_state(fitted[k]);
            if (wave.a_A - std::abs(wave.a_B) < 6 * run.sd[k]) {
                continue;
            }
            const double cosine = std::cos(wave.two_theta_A);
            const double sine = std::sin(wave.two_theta_A);
            const std::complex<double> s_A = run.c[k] * cosine + run.d[k] * sine;
            const std::complex<double> s_B = run.d[k] * cosine - run.c[k] * sine;
            const double power = std::norm(s_A) + std::norm(s_B);
            count += 1;
            time += run.time_s[k];
            sum += (s_A * std::conj(s_B)).real() / power;
            direction += std::polar(1.0, 2 * wave.two_theta_A);
            variance += run.sd[k] * run.sd[k] / power;
        }
        if (count > 0) {
            balance.time_s.push_back(time / count);
            balance.theta_rad.push_back(std::arg(direction) / 4);
            balance.orthogonality.push_back(sum / count);
            balance.sd.push_back(std::sqrt(variance) / count);
        }
    }
    return balance;
}

}  // namespace vybeg
