#include "core/resonator/runs/run_track.h"

#include "core/estimators/wave/wave_state.h"
#include "core/numerics/phase.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

// Sums over the windows of one point.
struct Sums {
    double count = 0;
    double time_s = 0;
    double a_A = 0;
    double a_B = 0;
    double two_theta_A = 0;
    double variance = 0;
    double angle_variance = 0;
    double turns = 0;    // of the phase, relative to f_ref
    double seconds = 0;  // that they took
    double power = 0;
};

double advance(const PhasorRun& run, std::size_t k) {
    const std::complex<double> step =
        run.c[k] * std::conj(run.c[k - 1]) + run.d[k] * std::conj(run.d[k - 1]);
    return std::arg(step) / (2 * std::numbers::pi);
}

void append(const Sums& sums, double f_ref_hz, RunTrack& track) {
    const double n = sums.count;
    track.time_s.push_back(sums.time_s / n);
    track.a_A.push_back(sums.a_A / n);
    track.a_B.push_back(sums.a_B / n);
    track.sd_a.push_back(std::sqrt(sums.variance) / n);
    track.two_theta_A.push_back(sums.two_theta_A / n);
    track.sd_two_theta_A.push_back(std::sqrt(sums.angle_variance) / n);
    // The sum of the phase steps is the difference of the ends, so only their noise remains.
    const double sd_phase = std::sqrt(2 * sums.variance / sums.power);
    const bool any = sums.seconds > 0;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    track.f_hz.push_back(any ? f_ref_hz + sums.turns / sums.seconds : none);
    track.sd_f_hz.push_back(any ? sd_phase / (2 * std::numbers::pi * sums.seconds) : none);
}

}  // namespace

RunTrack run_track(const PhasorRun& run, std::size_t most_points) {
    RunTrack track;
    const std::size_t windows = run.time_s.size();
    const std::size_t points = std::min(most_points, windows);
    double last_angle = 0;
    for (std::size_t point = 0; point < points; ++point) {
        const std::size_t first = point * windows / points;
        Sums sums;
        for (std::size_t k = first; k < (point + 1) * windows / points; ++k) {
            WaveState state = to_wave_state({run.c[k], run.d[k]});
            state.two_theta_A = nearest_branch(
                state.two_theta_A, k == 0 ? state.two_theta_A : last_angle, std::numbers::pi);
            last_angle = state.two_theta_A;
            const double power = state.a_A * state.a_A + state.a_B * state.a_B;
            const double variance = run.sd[k] * run.sd[k];
            const double difference = state.a_A * state.a_A - state.a_B * state.a_B;
            sums.count += 1;
            sums.time_s += run.time_s[k];
            sums.a_A += state.a_A;
            sums.a_B += state.a_B;
            sums.two_theta_A += state.two_theta_A;
            sums.variance += variance;
            sums.angle_variance += variance * power / (difference * difference);
            sums.power += power;
            if (k > first) {
                sums.turns += advance(run, k);
                sums.seconds += run.time_s[k] - run.time_s[k - 1];
            }
        }
        append(sums, run.f_ref_hz, track);
    }
    return track;
}

}  // namespace vybeg
