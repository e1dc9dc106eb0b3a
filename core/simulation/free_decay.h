#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

template <class S>
struct SettingRow;

// Another mode in the same recording, in the pick-off signals: adds a e^{-t/tau} cos(2 pi f t -
// phase) to each channel, before the pick-off's cubic.
struct ModeBeside {
    double f_hz = 0;
    double a_C = 0;
    double a_D = 0;
    double phase_C = 0;
    double phase_D = 0;
    double tau_s = 1e300;

    friend bool operator==(const ModeBeside&, const ModeBeside&) = default;
};

// A fault of the recorder: the `count` samples from `frame` on are missing. A negative count: they
// are recorded twice, one after the other. Frames are those of the undisturbed recording.
struct LostSamples {
    std::int64_t frame = 0;
    std::int64_t count = 0;

    friend bool operator==(const LostSamples&, const LostSamples&) = default;
};

// A simulated free decay (METHOD section 8): two degenerate modes of a resonator, let go at t = 0.
// Units in the names; angles in rad unless the name has another unit; amplitudes in recording
// units. The defaults are those of `simulate`: no error, no noise, no departure from the linear
// motion. demo_decay() is the article's case, with a split, a decay and a noise with which a_B
// visibly oscillates and 2theta_A crosses an axis.
//
// Slow motion of z = (c, d), relative to the carrier's phase 2 pi int f dt:
//     dz/dt = M z + i (2 pi b/3) (2|z|^2 z + (z.z) conj z) - k |z|^2 z
//           + [g(t) - dry/|z| - air |z|] z, g the drive between its instants
//     f(t) = f0 + drift t + settling e^{-t/settling_time}
// Channels, T = seconds:
//     C = c
//     D = [d(t - delay) (1 + gain_drift t/T) e^{i phase_drift t/T}
//          + (sin skew + i crosstalk) c] / kappa, d replaced by (1 - same) d + same c
//     S = s + cubic s^3 + offset + hum + noise, s the channel with the modes beside.
struct FreeDecay {
    double seconds = 28;
    double rate_hz = 33333;
    double f0_hz = 5300;
    double a_A = 1;
    double a_B = 0;
    double two_theta_A = 0.3;
    double alpha = 0.4;
    double split_hz = 0;                  // f_p - f_q >= 0
    double theta_w = 0;                   // axis of the faster mode
    double tau_s = 1e300;                 // amplitude decay time; the default is no decay
    double damping_anisotropy_per_s = 0;  // 1/tau_1 - 1/tau_2 >= 0
    double theta_tau = 0;                 // axis of larger damping
    double omega_rad_s = 0;               // rotation of the gyro
    double bryan = 0.277;                 // d theta_A/dt = -bryan * omega
    double noise = 0;                     // sd per sample and channel, recording units
    double kappa = 1;                     // S_D = D / kappa
    double offset_c = 0;
    double offset_d = 0;
    int bits = 0;           // 0: not quantised
    double full_scale = 0;  // of the quantiser; 0: 1.25 times the largest sample
    std::uint64_t seed = 1;

    // Frequency and motion.
    double frequency_drift_hz_s = 0;
    double settling_hz = 0;              // f(0) - f0
    double settling_time_s = 1;          // > 0
    double frequency_per_power_hz = 0;   // b: isotropic cubic spring, Hz per squared unit
    double damping_per_power_per_s = 0;  // k: 1/tau = 1/tau_s + k |z|^2, |z|^2 = a_A^2 + a_B^2
    // No free decay. Not together with the two dependences on the power.
    double dry_friction_per_s = 0;  // the amplitude |z| falls by this per second, until it rests
    double air_friction_per_s = 0;  // 1/tau = 1/tau_s + this times |z|
    double drive_per_s = 0;         // growth of the amplitude by a drive; negative: a touch
    double drive_from_s = 0;        // instants between which the drive is on
    double drive_to_s = 1e300;

    // Errors of the channels.
    double delay_d_s = 0;        // delay of channel D; |delay| <= 0.1 s
    double skew_deg = 0;         // the pick-off of D shows d + sin(skew) c
    double same_projection = 0;  // D shows (1 - x) d + x c; 1: both channels are on one electrode
    double crosstalk = 0;        // in quadrature: i c, C a quarter of a period early
    double phase_drift_rad = 0;  // of D, over the recording
    double gain_drift = 0;       // of D, over the recording, relative
    double pick_off_cubic = 0;   // of both channels, per squared unit
    double hum = 0;              // amplitude; hum cos(2 pi hum_hz t - hum_phase) in both channels
    double hum_hz = 50;
    double hum_phase = 0;

    // Noise about the carrier, in separate streams that leave the white noise unchanged.
    // Ornstein-Uhlenbeck processes about f0, independent for both channels: complex, each component
    // with the sd given and the correlation e^{-2 pi width |lag|}; `width` is half that of their
    // line at half its height.
    double carrier_noise = 0;     // added to c and d; relative to a_A at the start
    double modulation_noise = 0;  // multiplies c and d by 1 + noise
    double carrier_noise_width_hz = 0.1;
    // 1/f noise of the phase common to both channels: one-sided density phase_noise^2/f, rad^2/Hz,
    // between 0.1/T and a tenth of the carrier; its variance between f1 and f2 is
    // phase_noise^2 ln(f2/f1).
    double phase_noise_rad = 0;

    std::vector<ModeBeside> modes_beside = {};
    std::vector<LostSamples> lost = {};  // not overlapping, in the order of their frames

    friend bool operator==(const FreeDecay&, const FreeDecay&) = default;
};

FreeDecay demo_decay();

// The options of `simulate` that describe a decay, in the order of its help. The text of `hum`
// and `lose` is empty where they are not given; that of mode_beside_option may be read once for
// each mode, and is not written.
const std::vector<SettingRow<FreeDecay>>& decay_settings();
inline constexpr const char* mode_beside_option = "mode-beside";

// Whether friction or a drive changes the amplitude.
bool has_amplitude_factor(const FreeDecay& decay);

// Frames of the motion: floor(seconds * rate), a product within 1e-6 below a whole number counting
// as whole. Precondition: check() passes.
std::int64_t motion_frame_count(const FreeDecay& decay);

// Frames of the record: those of the motion less the lost, plus the doubled ones.
std::int64_t frame_count(const FreeDecay& decay);

// Whether the decay can be simulated at all: simulation_impossible with the reason.
Status check(const FreeDecay& decay);

// That it cannot.
inline Error impossible(std::string reason) {
    return {ErrorCode::simulation_impossible, "simulate", {std::move(reason)}};
}

}  // namespace vybeg
