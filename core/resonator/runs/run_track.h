#pragma once

#include "core/resonator/model/fitted_motion.h"
#include "core/resonator/model/phasor_run.h"

#include <cstddef>
#include <vector>

namespace vybeg {

// Slow variables of one run at a few points, for plots and passports: means over groups of
// consecutive windows, with their standard deviations. Times in s from the start of the recording,
// amplitudes in recording units, angles in rad, frequency in Hz.
struct RunTrack {
    std::vector<double> time_s;
    std::vector<double> a_A;
    std::vector<double> a_B;
    std::vector<double> sd_a;         // of a_A and of a_B
    std::vector<double> two_theta_A;  // unwrapped modulo pi, the first one in (-pi/2, pi/2]
    std::vector<double> sd_two_theta_A;
    std::vector<double> f_hz;  // mean rate of phase, weighted with power; NaN for a lone window
    std::vector<double> sd_f_hz;

    friend bool operator==(const RunTrack&, const RunTrack&) = default;
};

// At most `most_points` points with equal numbers of windows. Precondition: most_points >= 1.
RunTrack run_track(const PhasorRun& run, std::size_t most_points);

// Condition (30) along one run: <S_A S_B> / (<S_A^2> + <S_B^2>) in the axes of the fitted motion,
// at a few points. It is zero within its deviation if the channels are balanced as in the fit. It
// deviates if the gain or direction of a pick-off changes during the run or depends on the
// amplitude. A constant error looks like a damping anisotropy and is absorbed by the fit.
struct ChannelBalance {
    std::vector<double> time_s;
    std::vector<double> theta_rad;  // mean direction of the fitted wave, (-pi/4, pi/4]
    std::vector<double> orthogonality;
    std::vector<double> sd;
};

// At most `most_points` means over consecutive windows. `motion` is that of the structured model;
// `index` is the run's place in it. Windows with a circular fitted wave have no axes and are
// ignored.
ChannelBalance channel_balance(const PhasorRun& run, const FittedMotion& motion, std::size_t index,
                               std::size_t most_points);

}  // namespace vybeg
