#include "core/simulation/free_decay.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <initializer_list>

namespace vybeg {
namespace {

constexpr std::int64_t most_frames = std::int64_t{1} << 36;   // three weeks at 33333 Hz
constexpr std::int64_t most_doubled = std::int64_t{1} << 20;  // held in memory
constexpr double longest_delay_s = 0.1;

double start_power(const FreeDecay& decay) {
    return decay.a_A * decay.a_A + decay.a_B * decay.a_B;
}

// What a decay must not be, and the words for it.
struct Rule {
    bool broken;
    const char* words;
};

Status first_broken(std::initializer_list<Rule> rules) {
    for (const Rule& rule : rules) {
        if (rule.broken) {
            return impossible(rule.words);
        }
    }
    return {};
}

// Beyond these bounds the motion overflows or loses its digits.
Status check_sizes(const FreeDecay& decay) {
    constexpr double most_amplitude = 1e30;
    constexpr double most_angle = 1e6;
    const auto beyond = [](double most) { return [most](double x) { return std::abs(x) > most; }; };
    if (std::ranges::any_of(
            std::array{decay.a_A, decay.a_B, decay.noise, decay.offset_c, decay.offset_d,
                       decay.full_scale, decay.hum, decay.carrier_noise, decay.modulation_noise},
            beyond(most_amplitude))) {
        return impossible("amplitudes, noise, offsets and full scale must lie within +-1e30");
    }
    if (std::ranges::any_of(
            std::array{decay.two_theta_A, decay.alpha, decay.theta_w, decay.theta_tau,
                       decay.skew_deg, decay.phase_drift_rad, decay.hum_phase},
            beyond(most_angle))) {
        return impossible("angles must lie within +-1e6 rad");
    }
    if (std::ranges::any_of(std::array{decay.omega_rad_s, decay.bryan}, beyond(1e6))) {
        return impossible("the rotation and Bryan's factor must lie within +-1e6");
    }
    if (decay.split_hz >= 2 * decay.f0_hz ||
        decay.f0_hz + decay.split_hz / 2 >= decay.rate_hz / 2) {
        return impossible(
            "with a split of " + short_text(decay.split_hz) +
            " Hz the modes' frequencies are not between 0 and half the sample rate, " +
            short_text(decay.rate_hz / 2) + " Hz");
    }
    return first_broken({{decay.tau_s < 1e-9, "the decay time must be at least 1e-9 s"},
                         {decay.kappa < 1e-6 || decay.kappa > 1e6,
                          "the gain ratio kappa must lie between 1e-6 and 1e6"}});
}

Status check_motion(const FreeDecay& decay) {
    if (decay.settling_time_s <= 0) {
        return impossible("the settling time must be above 0");
    }
    // Each part is monotonic, so that these are bounds of their sum.
    const std::array parts{decay.frequency_drift_hz_s * decay.seconds, decay.settling_hz,
                           decay.frequency_per_power_hz * start_power(decay)};
    double lowest = decay.f0_hz;
    double highest = decay.f0_hz;
    for (const double part : parts) {
        lowest += std::min(part, 0.0);
        highest += std::max(part, 0.0);
    }
    if (lowest <= 0 || highest >= decay.rate_hz / 2) {
        return impossible("the frequency may run from " + short_text(lowest) + " to " +
                          short_text(highest) +
                          " Hz, which is not between 0 and half the sample rate, " +
                          short_text(decay.rate_hz / 2) + " Hz");
    }
    const double by_power = decay.damping_per_power_per_s * start_power(decay);
    if (decay.damping_per_power_per_s < 0 &&
        1 / decay.tau_s + by_power < decay.damping_anisotropy_per_s / 2) {
        return impossible("the damping per power would let the wave grow at the start");
    }
    return {};
}

// Departures from a free decay. Their sizes bound the steps of AmplitudeFactor.
Status check_drive(const FreeDecay& decay) {
    constexpr double most_growth = 100;  // of the logarithm
    const double driven_s = std::max(
        std::min(decay.drive_to_s, decay.seconds) - std::max(decay.drive_from_s, 0.0), 0.0);
    const bool by_power = decay.frequency_per_power_hz != 0 || decay.damping_per_power_per_s != 0;
    return first_broken({{decay.dry_friction_per_s < 0 || decay.air_friction_per_s < 0,
                          "a friction cannot be negative"},
                         {std::abs(decay.drive_per_s) * driven_s > most_growth,
                          "the drive changes the amplitude by more than e^100"},
                         {has_amplitude_factor(decay) && by_power,
                          "friction or drive, and a dependence on the power, exclude each other"}});
}

Status check_channels(const FreeDecay& decay) {
    const double growth =
        std::max(1 / decay.tau_s, std::abs(decay.damping_per_power_per_s) * start_power(decay));
    return first_broken(
        {{std::abs(decay.delay_d_s) > longest_delay_s || std::abs(decay.delay_d_s) * growth > 0.1,
          "the delay of D is at most 0.1 s and a tenth of the decay time"},
         {decay.gain_drift <= -1, "the gain drift must be above -1"},
         {decay.hum != 0 && (decay.hum_hz < 0 || decay.hum_hz >= decay.rate_hz / 2),
          "the hum's frequency must be between 0 and half the sample rate"},
         {decay.carrier_noise < 0 || decay.modulation_noise < 0 || decay.phase_noise_rad < 0,
          "the noise about the carrier cannot be negative"},
         {decay.carrier_noise_width_hz <= 0,
          "the width of the noise about the carrier must be above 0"}});
}

Status check_modes_beside(const FreeDecay& decay) {
    for (const ModeBeside& mode : decay.modes_beside) {
        const std::array numbers{mode.f_hz,    mode.a_C,     mode.a_D,
                                 mode.phase_C, mode.phase_D, mode.tau_s};
        if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); })) {
            return impossible("every parameter must be a finite number");
        }
        if (mode.f_hz <= 0 || mode.f_hz >= decay.rate_hz / 2) {
            return impossible("the mode of " + short_text(mode.f_hz) +
                              " Hz is not between 0 and half the sample rate, " +
                              short_text(decay.rate_hz / 2) + " Hz");
        }
        if (mode.tau_s <= 0) {
            return impossible("the decay time must be above 0");
        }
    }
    return {};
}

Status check_losses(const FreeDecay& decay) {
    const std::int64_t frames = motion_frame_count(decay);
    std::int64_t free = 0;  // first frame after the previous fault
    for (const LostSamples& fault : decay.lost) {
        if (fault.count < -most_doubled || fault.count > frames || fault.count == 0) {
            return impossible("samples lost are 1 to " + integer_text(frames) +
                              ", samples doubled at most " + integer_text(most_doubled));
        }
        if (fault.frame < free || fault.frame > frames - std::abs(fault.count)) {
            return impossible("the samples lost at frame " + integer_text(fault.frame) +
                              " do not lie inside the record, behind those lost before");
        }
        free = fault.frame + std::abs(fault.count);
    }
    if (frame_count(decay) < 1) {
        return impossible("every sample would be lost");
    }
    return {};
}

}  // namespace

FreeDecay demo_decay() {
    FreeDecay decay;
    decay.split_hz = 0.012;
    decay.theta_w = -0.2;
    decay.tau_s = 30;
    decay.damping_anisotropy_per_s = 0.002;
    decay.theta_tau = 0.3;
    decay.omega_rad_s = 0.08;
    decay.noise = 1e-3;
    return decay;
}

bool has_amplitude_factor(const FreeDecay& decay) {
    return decay.dry_friction_per_s != 0 || decay.air_friction_per_s != 0 || decay.drive_per_s != 0;
}

std::int64_t motion_frame_count(const FreeDecay& decay) {
    return static_cast<std::int64_t>(std::floor(decay.seconds * decay.rate_hz + 1e-6));
}

std::int64_t frame_count(const FreeDecay& decay) {
    std::int64_t frames = motion_frame_count(decay);
    for (const LostSamples& fault : decay.lost) {
        frames -= fault.count;
    }
    return frames;
}

Status check(const FreeDecay& decay) {
    const std::array numbers{decay.seconds,
                             decay.rate_hz,
                             decay.f0_hz,
                             decay.a_A,
                             decay.a_B,
                             decay.two_theta_A,
                             decay.alpha,
                             decay.split_hz,
                             decay.theta_w,
                             decay.tau_s,
                             decay.theta_tau,
                             decay.damping_anisotropy_per_s,
                             decay.bryan,
                             decay.omega_rad_s,
                             decay.noise,
                             decay.kappa,
                             decay.offset_c,
                             decay.offset_d,
                             decay.full_scale,
                             decay.frequency_drift_hz_s,
                             decay.settling_hz,
                             decay.settling_time_s,
                             decay.frequency_per_power_hz,
                             decay.damping_per_power_per_s,
                             decay.dry_friction_per_s,
                             decay.air_friction_per_s,
                             decay.drive_per_s,
                             decay.drive_from_s,
                             decay.drive_to_s,
                             decay.same_projection,
                             decay.delay_d_s,
                             decay.skew_deg,
                             decay.crosstalk,
                             decay.phase_drift_rad,
                             decay.gain_drift,
                             decay.pick_off_cubic,
                             decay.hum,
                             decay.hum_hz,
                             decay.hum_phase,
                             decay.carrier_noise,
                             decay.modulation_noise,
                             decay.carrier_noise_width_hz,
                             decay.phase_noise_rad};
    if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); })) {
        return impossible("every parameter must be a finite number");
    }
    if (decay.seconds <= 0 || decay.rate_hz <= 0) {
        return impossible("the length and the sample rate must be above 0");
    }
    if (decay.f0_hz <= 0 || decay.f0_hz >= decay.rate_hz / 2) {
        return impossible("the carrier of " + short_text(decay.f0_hz) +
                          " Hz is not between 0 and half the sample rate, " +
                          short_text(decay.rate_hz / 2) + " Hz");
    }
    if (decay.seconds * decay.rate_hz > static_cast<double>(most_frames)) {
        return impossible(short_text(decay.seconds * decay.rate_hz) +
                          " samples are too many; the most is " + integer_text(most_frames));
    }
    TRY(first_broken({{motion_frame_count(decay) < 1, "the record is shorter than one sample"},
                      {decay.tau_s <= 0, "the decay time must be above 0"},
                      {decay.split_hz < 0 || decay.damping_anisotropy_per_s < 0,
                       "frequency split and damping anisotropy cannot be negative"}}));
    if (decay.damping_anisotropy_per_s > 2 / decay.tau_s) {
        return impossible("a damping anisotropy above 2/tau = " + short_text(2 / decay.tau_s) +
                          " 1/s would let one mode grow");
    }
    TRY(first_broken(
        {{decay.noise < 0, "the noise cannot be negative"},
         {decay.kappa <= 0, "the gain ratio kappa must be above 0"},
         {decay.bits != 0 && (decay.bits < 2 || decay.bits > 32), "the quantiser has 2 to 32 bits"},
         {decay.full_scale < 0, "the full scale cannot be negative"}}));
    for (const auto& part : {check_sizes, check_motion, check_drive, check_channels,
                             check_modes_beside, check_losses}) {
        TRY(part(decay));
    }
    return {};
}

}  // namespace vybeg
