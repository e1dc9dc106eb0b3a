#include "core/simulation/free_decay.h"

#include "core/base/number_text.h"
#include "core/base/setting_rows.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <system_error>
#include <tuple>
#include <utility>

namespace vybeg {
namespace {

struct DecayOption {
    const char* name;
    double FreeDecay::*member;
    const char* placeholder;
    const char* help;
};

constexpr auto decay_options = std::to_array<DecayOption>({
    {"seconds", &FreeDecay::seconds, "S", "Length, s"},
    {"rate", &FreeDecay::rate_hz, "HZ", "Sample rate, Hz"},
    {"f0", &FreeDecay::f0_hz, "HZ", "Carrier: mean frequency of the two modes, Hz"},
    {"a-A", &FreeDecay::a_A, "X", "Amplitude of the working wave at t = 0"},
    {"a-B", &FreeDecay::a_B, "X", "Amplitude of the quadrature wave at t = 0"},
    {"two-theta-A", &FreeDecay::two_theta_A, "RAD", "Angle 2theta_A at t = 0, rad"},
    {"alpha", &FreeDecay::alpha, "RAD", "Phase at t = 0, rad"},
    {"split", &FreeDecay::split_hz, "HZ", "Frequency split f_p - f_q, Hz"},
    {"theta-w", &FreeDecay::theta_w, "RAD", "Axis of the faster mode, rad"},
    {"tau", &FreeDecay::tau_s, "S", "Amplitude decay time, s; 1e300: no decay"},
    {"damping-anisotropy", &FreeDecay::damping_anisotropy_per_s, "1/S", "1/tau_1 - 1/tau_2, 1/s"},
    {"theta-tau", &FreeDecay::theta_tau, "RAD", "Axis of larger damping, rad"},
    {"omega", &FreeDecay::omega_rad_s, "RAD/S", "Rotation of the gyro, rad/s"},
    {"bryan", &FreeDecay::bryan, "K",
     "Bryan's factor: d theta_A/dt = -K omega for a perfect resonator"},
    {"noise", &FreeDecay::noise, "SIGMA", "Standard deviation of the noise per sample and channel"},
    {"kappa", &FreeDecay::kappa, "K", "Gain ratio of the channels: S_D = D / K"},
    {"frequency-drift", &FreeDecay::frequency_drift_hz_s, "HZ/S",
     "Linear drift of the frequency, Hz/s"},
    {"settling", &FreeDecay::settling_hz, "HZ",
     "The frequency begins HZ above f0 and settles exponentially"},
    {"settling-time", &FreeDecay::settling_time_s, "S", "Time constant of --settling, s"},
    {"frequency-per-power", &FreeDecay::frequency_per_power_hz, "HZ",
     "Isotropic cubic spring: frequency per a_A^2 + a_B^2, Hz"},
    {"damping-per-power", &FreeDecay::damping_per_power_per_s, "1/S",
     "Amplitude's decay rate per a_A^2 + a_B^2, 1/s"},
    {"dry-friction", &FreeDecay::dry_friction_per_s, "X",
     "Dry friction: fall of the amplitude per second, until the wave rests"},
    {"air-friction", &FreeDecay::air_friction_per_s, "1/S",
     "Amplitude's decay rate per unit of the amplitude, 1/s"},
    {"drive", &FreeDecay::drive_per_s, "1/S",
     "Growth rate of the amplitude by a drive, 1/s; 1/tau holds it; negative: a touch"},
    {"drive-from", &FreeDecay::drive_from_s, "S", "The drive begins, s"},
    {"drive-to", &FreeDecay::drive_to_s, "S", "The drive ends, s"},
    {"delay", &FreeDecay::delay_d_s, "S", "Channel D comes late by S seconds"},
    {"skew", &FreeDecay::skew_deg, "DEG", "Channel D shows D + sin(skew) C, degrees"},
    {"same-projection", &FreeDecay::same_projection, "X",
     "Channel D shows (1 - X) D + X C; 1: both on one electrode"},
    {"crosstalk", &FreeDecay::crosstalk, "X",
     "Crosstalk in quadrature: channel D adds X times C a quarter of a period early"},
    {"phase-drift", &FreeDecay::phase_drift_rad, "RAD",
     "Phase of D against C, drift over the recording, rad"},
    {"gain-drift", &FreeDecay::gain_drift, "X", "Gain of D, relative drift over the recording"},
    {"pick-off-cubic", &FreeDecay::pick_off_cubic, "X", "Both channels: S + X S^3 in place of S"},
    {"carrier-noise", &FreeDecay::carrier_noise, "X",
     "Noise about the carrier, standard deviation of each component of a channel's "
     "phasor, relative to a_A at t = 0"},
    {"modulation-noise", &FreeDecay::modulation_noise, "X",
     "The same, relative to the channel's own phasor"},
    {"carrier-noise-width", &FreeDecay::carrier_noise_width_hz, "HZ", "Half width of both, Hz"},
    {"phase-noise", &FreeDecay::phase_noise_rad, "RAD",
     "1/f phase noise common to both channels, density RAD^2/f, rad^2/Hz"},
});

using Row = SettingRow<FreeDecay>;

// A number without a unit; check() holds its bounds.
Row number_of(const Row& row, double FreeDecay::*member) {
    return value_row<double>(
        row, [member](auto& decay) -> auto& { return decay.*member; },
        [name = row.option()](const std::string& text) { return read_number(name, text); },
        round_trip_text, any_value);
}

// FRAME:COUNT,...
Status read_lost(const std::string& text, FreeDecay& decay) {
    std::vector<LostSamples> lost;
    std::size_t begin = 0;
    do {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::size_t colon = text.find(':', begin);
        if (colon >= end) {
            return refused_value("--lose", text, "it is FRAME:COUNT, several with commas");
        }
        const auto frame = TRY(read_whole("--lose", text.substr(begin, colon - begin)));
        const auto count = TRY(read_whole("--lose", text.substr(colon + 1, end - colon - 1)));
        lost.push_back({frame, count});
        begin = end + 1;
    } while (begin < text.size());
    decay.lost = std::move(lost);
    return {};
}

constexpr std::int64_t most_frames = std::int64_t{1} << 36;   // three weeks at 33333 Hz
constexpr std::int64_t most_doubled = std::int64_t{1} << 20;  // held in memory
constexpr double longest_delay_s = 0.1;

bool are_finite(std::initializer_list<double> numbers) {
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

double start_power(const FreeDecay& decay) {
    return decay.a_A * decay.a_A + decay.a_B * decay.a_B;
}

// What a decay must not be, and the words for it.
struct Rule {
    bool broken;
    std::string words;
};

Status first_broken(const std::vector<Rule>& rules) {
    const auto broken = std::ranges::find(rules, true, &Rule::broken);
    return broken == rules.end() ? Status() : impossible(broken->words);
}

// "... not between 0 and half the sample rate, 16666.5 Hz".
std::string not_below_half(const FreeDecay& decay, const char* is) {
    return std::string(is) + " not between 0 and half the sample rate, " +
           short_text(decay.rate_hz / 2) + " Hz";
}

// Beyond these bounds the motion overflows or loses its digits.
Status check_sizes(const FreeDecay& decay) {
    const auto beyond = [](double most, std::initializer_list<double> numbers) {
        return std::ranges::any_of(numbers, [most](double x) { return std::abs(x) > most; });
    };
    return first_broken(
        {{beyond(1e30, {decay.a_A, decay.a_B, decay.noise, decay.offset_c, decay.offset_d,
                        decay.full_scale, decay.hum, decay.carrier_noise, decay.modulation_noise}),
          "amplitudes, noise, offsets and full scale must lie within +-1e30"},
         {beyond(1e6, {decay.two_theta_A, decay.alpha, decay.theta_w, decay.theta_tau,
                       decay.skew_deg, decay.phase_drift_rad, decay.hum_phase}),
          "angles must lie within +-1e6 rad"},
         {beyond(1e6, {decay.omega_rad_s, decay.bryan}),
          "the rotation and Bryan's factor must lie within +-1e6"},
         {decay.split_hz >= 2 * decay.f0_hz ||
              decay.f0_hz + decay.split_hz / 2 >= decay.rate_hz / 2,
          "with a split of " + short_text(decay.split_hz) +
              not_below_half(decay, " Hz the modes' frequencies are")},
         {decay.tau_s < 1e-9, "the decay time must be at least 1e-9 s"},
         {decay.kappa < 1e-6 || decay.kappa > 1e6,
          "the gain ratio kappa must lie between 1e-6 and 1e6"}});
}

Status check_motion(const FreeDecay& decay) {
    // Each part is monotonic, so that these are bounds of their sum.
    const std::array parts{decay.frequency_drift_hz_s * decay.seconds, decay.settling_hz,
                           decay.frequency_per_power_hz * start_power(decay)};
    double lowest = decay.f0_hz;
    double highest = decay.f0_hz;
    for (const double part : parts) {
        lowest += std::min(part, 0.0);
        highest += std::max(part, 0.0);
    }
    const double by_power = decay.damping_per_power_per_s * start_power(decay);
    return first_broken({{decay.settling_time_s <= 0, "the settling time must be above 0"},
                         {lowest <= 0 || highest >= decay.rate_hz / 2,
                          "the frequency may run from " + short_text(lowest) + " to " +
                              short_text(highest) + not_below_half(decay, " Hz, which is")},
                         {decay.damping_per_power_per_s < 0 &&
                              1 / decay.tau_s + by_power < decay.damping_anisotropy_per_s / 2,
                          "the damping per power would let the wave grow at the start"}});
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
        TRY(first_broken(
            {{!are_finite({mode.f_hz, mode.a_C, mode.a_D, mode.phase_C, mode.phase_D, mode.tau_s}),
              "every parameter must be a finite number"},
             {mode.f_hz <= 0 || mode.f_hz >= decay.rate_hz / 2,
              "the mode of " + short_text(mode.f_hz) + not_below_half(decay, " Hz is")},
             {mode.tau_s <= 0, "the decay time must be above 0"}}));
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

const std::vector<SettingRow<FreeDecay>>& decay_settings() {
    static const std::vector<Row> rows = [] {
        std::vector<Row> all;
        for (const DecayOption& option : decay_options) {
            const std::string usual = round_trip_text(FreeDecay{}.*option.member);
            const std::string help = std::string(option.help) + " (default " + usual + ")";
            all.push_back(number_of({option.name, option.placeholder, help}, option.member));
        }
        all.insert(
            all.end(),
            {{"offset", "C,D", "Offsets of the channels (default 0,0)",
              [](const std::string& text, FreeDecay& decay) -> Status {
                  const auto x = TRY(read_numbers("--offset", text, 2, "it is two numbers C,D"));
                  std::tie(decay.offset_c, decay.offset_d) = std::pair(x[0], x[1]);
                  return {};
              },
              [](const FreeDecay& decay) {
                  return joined({decay.offset_c, decay.offset_d});
              }},
             {"hum", "X,HZ,RAD", "Mains in both channels: amplitude, frequency, phase",
              [](const std::string& text, FreeDecay& decay) -> Status {
                  const auto x =
                      TRY(read_numbers("--hum", text, 3, "it is three numbers X,HZ,RAD"));
                  std::tie(decay.hum, decay.hum_hz, decay.hum_phase) = std::tuple(x[0], x[1], x[2]);
                  return {};
              },
              [](const FreeDecay& decay) {
                  return decay.hum == 0 ? std::string()
                                        : joined({decay.hum, decay.hum_hz, decay.hum_phase});
              }},
             {mode_beside_option, "HZ,A_C,A_D,PHASE_C,PHASE_D,TAU",
              "Another mode in both channels: A cos(2 pi HZ t - PHASE) e^(-t/TAU); once for each",
              [](const std::string& text, FreeDecay& decay) -> Status {
                  const auto x =
                      TRY(read_numbers("--mode-beside", text, 6,
                                       "it is six numbers HZ,A_C,A_D,PHASE_C,PHASE_D,TAU"));
                  decay.modes_beside.push_back({x[0], x[1], x[2], x[3], x[4], x[5]});
                  return {};
              }},
             {"lose", "FRAME:COUNT,...",
              "Cut COUNT samples out from FRAME on; a negative COUNT: record them twice", read_lost,
              [](const FreeDecay& decay) {
                  return joined(decay.lost, ",", [](const LostSamples& fault) {
                      return integer_text(fault.frame) + ":" + integer_text(fault.count);
                  });
              }},
             {"bits", "B", "Quantise to B bits, 2 to 32 (default: do not)",
              [](const std::string& text, FreeDecay& decay) -> Status {
                  const auto bits = TRY(read_whole("--bits", text));
                  decay.bits = static_cast<int>(std::clamp<std::int64_t>(bits, 0, 33));
                  return decay.bits >= 2 && decay.bits <= 32
                             ? Status()
                             : refused_value("--bits", text, "it is 2 to 32");
              },
              [](const FreeDecay& decay) { return std::to_string(decay.bits); }},
             number_of({"full-scale", "X",
                        "Full scale of --bits (default: 1.25 times the largest sample)"},
                       &FreeDecay::full_scale),
             {"seed", "N", "Seed of the noise (default 1)",
              [](const std::string& text, FreeDecay& decay) {
                  const char* const end = text.data() + text.size();
                  const auto parsed = std::from_chars(text.data(), end, decay.seed);
                  return parsed.ec == std::errc{} && parsed.ptr == end
                             ? Status()
                             : refused_value("--seed", text,
                                             "it must be a whole number, not negative");
              },
              [](const FreeDecay& decay) { return std::to_string(decay.seed); }}});
        return all;
    }();
    return rows;
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
    const bool finite = std::ranges::all_of(decay_options,
                                            [&decay](const DecayOption& each) {
                                                return std::isfinite(decay.*each.member);
                                            }) &&
                        are_finite({decay.offset_c, decay.offset_d, decay.full_scale, decay.hum,
                                    decay.hum_hz, decay.hum_phase});
    const double frames = decay.seconds * decay.rate_hz;
    TRY(first_broken(
        {{!finite, "every parameter must be a finite number"},
         {decay.seconds <= 0 || decay.rate_hz <= 0,
          "the length and the sample rate must be above 0"},
         {decay.f0_hz <= 0 || decay.f0_hz >= decay.rate_hz / 2,
          "the carrier of " + short_text(decay.f0_hz) + not_below_half(decay, " Hz is")},
         {frames > static_cast<double>(most_frames), short_text(frames) +
                                                         " samples are too many; the most is " +
                                                         integer_text(most_frames)}}));
    TRY(first_broken(
        {{motion_frame_count(decay) < 1, "the record is shorter than one sample"},
         {decay.tau_s <= 0, "the decay time must be above 0"},
         {decay.split_hz < 0 || decay.damping_anisotropy_per_s < 0,
          "frequency split and damping anisotropy cannot be negative"},
         {decay.damping_anisotropy_per_s > 2 / decay.tau_s,
          "a damping anisotropy above 2/tau = " + short_text(2 / decay.tau_s) +
              " 1/s would let one mode grow"},
         {decay.noise < 0, "the noise cannot be negative"},
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
