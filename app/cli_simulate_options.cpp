#include "app/cli_simulate_options.h"

#include "app/option_values.h"
#include "core/base/number_text.h"

#include <array>
#include <charconv>

namespace vybeg::cli {
namespace {

struct DecayOption {
    const char* name;
    double FreeDecay::*member;
    const char* placeholder;
    const char* help;
};

constexpr std::array decay_options{
    DecayOption{"seconds", &FreeDecay::seconds, "S", "Length, s"},
    DecayOption{"rate", &FreeDecay::rate_hz, "HZ", "Sample rate, Hz"},
    DecayOption{"f0", &FreeDecay::f0_hz, "HZ", "Carrier: mean frequency of the two modes, Hz"},
    DecayOption{"a-A", &FreeDecay::a_A, "X", "Amplitude of the working wave at t = 0"},
    DecayOption{"a-B", &FreeDecay::a_B, "X", "Amplitude of the quadrature wave at t = 0"},
    DecayOption{"two-theta-A", &FreeDecay::two_theta_A, "RAD", "Angle 2theta_A at t = 0, rad"},
    DecayOption{"alpha", &FreeDecay::alpha, "RAD", "Phase at t = 0, rad"},
    DecayOption{"split", &FreeDecay::split_hz, "HZ", "Frequency split f_p - f_q, Hz"},
    DecayOption{"theta-w", &FreeDecay::theta_w, "RAD", "Axis of the faster mode, rad"},
    DecayOption{"tau", &FreeDecay::tau_s, "S", "Amplitude decay time, s; 1e300: no decay"},
    DecayOption{"damping-anisotropy", &FreeDecay::damping_anisotropy_per_s, "1/S",
                "1/tau_1 - 1/tau_2, 1/s"},
    DecayOption{"theta-tau", &FreeDecay::theta_tau, "RAD", "Axis of larger damping, rad"},
    DecayOption{"omega", &FreeDecay::omega_rad_s, "RAD/S", "Rotation of the gyro, rad/s"},
    DecayOption{"bryan", &FreeDecay::bryan, "K",
                "Bryan's factor: d theta_A/dt = -K omega for a perfect resonator"},
    DecayOption{"noise", &FreeDecay::noise, "SIGMA",
                "Standard deviation of the noise per sample and channel"},
    DecayOption{"kappa", &FreeDecay::kappa, "K", "Gain ratio of the channels: S_D = D / K"},
};

std::string with_default(const std::string& help, const std::string& value) {
    return help + " (default " + value + ")";
}

std::string offset_text(const FreeDecay& decay) {
    return round_trip_text(decay.offset_c) + "," + round_trip_text(decay.offset_d);
}

}  // namespace

void add_simulate_options(CLI::App& app, SimulateRequest& request) {
    FreeDecay& decay = request.decay;
    app.add_option("-o,--output", request.output,
                   "Samples, by the ending: .wav (64-bit float; PCM with --bits), .csv, .npy, "
                   ".mat; - for CSV on standard output")
        ->type_name("FILE")
        ->required();
    add_value(app, "--truth", "FILE", "The true track, CSV; - for standard output",
              [&request](const auto&, const auto& text) { request.truth = text; });
    add_value(app, "--window", "N", "Window of the truth, samples (default 60)",
              [&request](const auto& option, const auto& text) {
                  request.window = whole_value(option, text);
              });
    // Options act in the order of their definition: what is typed changes the demo.
    app.add_flag_callback(
        "--demo", [&decay] { decay = demo_decay(); },
        "The article's case, 28 s at 33333 Hz: a swing of the quadrature, a turn through an axis, "
        "noise of 60 dB. Other options change it");
    for (const DecayOption& option : decay_options) {
        add_number(app, std::string("--") + option.name, decay.*option.member, option.placeholder,
                   with_default(option.help, round_trip_text(decay.*option.member)));
    }
    add_value(app, "--offset", "C,D", with_default("Offsets of the channels", offset_text(decay)),
              [&decay](const auto& option, const auto& text) {
                  const auto offsets = list_value(option, text, 2, "it is two numbers C,D");
                  decay.offset_c = offsets[0];
                  decay.offset_d = offsets[1];
              });
    add_value(app, "--bits", "B", "Quantise to B bits, 2 to 32 (default: do not)",
              [&decay](const auto& option, const auto& text) {
                  const std::int64_t bits = whole_value(option, text);
                  if (bits < 2 || bits > 32) {
                      reject(option, text, "it is 2 to 32");
                  }
                  decay.bits = static_cast<int>(bits);
              });
    add_number(app, "--full-scale", decay.full_scale, "X",
               "Full scale of --bits (default: 1.25 times the largest sample)");
    add_value(app, "--seed", "N", "Seed of the noise (default 1)",
              [&decay](const auto& option, const auto& text) {
                  const char* const end = text.data() + text.size();
                  const auto parsed = std::from_chars(text.data(), end, decay.seed);
                  if (parsed.ec != std::errc{} || parsed.ptr != end) {
                      reject(option, text, "it must be a whole number, not negative");
                  }
              });
}

std::vector<std::pair<std::string, std::string>> decay_list(const FreeDecay& decay) {
    std::vector<std::pair<std::string, std::string>> list;
    for (const DecayOption& option : decay_options) {
        list.emplace_back(option.name, round_trip_text(decay.*option.member));
    }
    list.emplace_back("offset", offset_text(decay));
    list.emplace_back("bits", std::to_string(decay.bits));
    list.emplace_back("full-scale", round_trip_text(decay.full_scale));
    list.emplace_back("seed", std::to_string(decay.seed));
    return list;
}

}  // namespace vybeg::cli
