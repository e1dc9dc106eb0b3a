#include "app/cli_commands.h"
#include "app/cli_support.h"
#include "app/command_line.h"
#include "core/analysis/setting_table.h"
#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/base/read_value.h"
#include "core/base/setting_rows.h"
#include "core/output/output_file.h"
#include "core/output/sample_files.h"
#include "core/output/track_file.h"
#include "core/simulation/simulate.h"
#include "core/simulation/software_lock_in.h"
#include "core/simulation/true_track.h"
#include "core/track/track.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

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
    DecayOption{"frequency-drift", &FreeDecay::frequency_drift_hz_s, "HZ/S",
                "Linear drift of the frequency, Hz/s"},
    DecayOption{"settling", &FreeDecay::settling_hz, "HZ",
                "The frequency begins HZ above f0 and settles exponentially"},
    DecayOption{"settling-time", &FreeDecay::settling_time_s, "S",
                "Time constant of --settling, s"},
    DecayOption{"frequency-per-power", &FreeDecay::frequency_per_power_hz, "HZ",
                "Isotropic cubic spring: frequency per a_A^2 + a_B^2, Hz"},
    DecayOption{"damping-per-power", &FreeDecay::damping_per_power_per_s, "1/S",
                "Amplitude's decay rate per a_A^2 + a_B^2, 1/s"},
    DecayOption{"dry-friction", &FreeDecay::dry_friction_per_s, "X",
                "Dry friction: fall of the amplitude per second, until the wave rests"},
    DecayOption{"air-friction", &FreeDecay::air_friction_per_s, "1/S",
                "Amplitude's decay rate per unit of the amplitude, 1/s"},
    DecayOption{"drive", &FreeDecay::drive_per_s, "1/S",
                "Growth rate of the amplitude by a drive, 1/s; 1/tau holds it; negative: a touch"},
    DecayOption{"drive-from", &FreeDecay::drive_from_s, "S", "The drive begins, s"},
    DecayOption{"drive-to", &FreeDecay::drive_to_s, "S", "The drive ends, s"},
    DecayOption{"delay", &FreeDecay::delay_d_s, "S", "Channel D comes late by S seconds"},
    DecayOption{"skew", &FreeDecay::skew_deg, "DEG", "Channel D shows D + sin(skew) C, degrees"},
    DecayOption{"same-projection", &FreeDecay::same_projection, "X",
                "Channel D shows (1 - X) D + X C; 1: both on one electrode"},
    DecayOption{"crosstalk", &FreeDecay::crosstalk, "X",
                "Crosstalk in quadrature: channel D adds X times C a quarter of a period early"},
    DecayOption{"phase-drift", &FreeDecay::phase_drift_rad, "RAD",
                "Phase of D against C, drift over the recording, rad"},
    DecayOption{"gain-drift", &FreeDecay::gain_drift, "X",
                "Gain of D, relative drift over the recording"},
    DecayOption{"pick-off-cubic", &FreeDecay::pick_off_cubic, "X",
                "Both channels: S + X S^3 in place of S"},
    DecayOption{"carrier-noise", &FreeDecay::carrier_noise, "X",
                "Noise about the carrier, standard deviation of each component of a channel's "
                "phasor, relative to a_A at t = 0"},
    DecayOption{"modulation-noise", &FreeDecay::modulation_noise, "X",
                "The same, relative to the channel's own phasor"},
    DecayOption{"carrier-noise-width", &FreeDecay::carrier_noise_width_hz, "HZ",
                "Half width of both, Hz"},
    DecayOption{"phase-noise", &FreeDecay::phase_noise_rad, "RAD",
                "1/f phase noise common to both channels, density RAD^2/f, rad^2/Hz"},
};

std::string with_default(const std::string& help, const std::string& value) {
    return help + " (default " + value + ")";
}

std::string offset_text(const FreeDecay& decay) {
    return joined({decay.offset_c, decay.offset_d});
}

// FRAME:COUNT,...
std::vector<LostSamples> lost_value(const std::string& option, const std::string& text) {
    std::vector<LostSamples> lost;
    for (const std::string& fault : CLI::detail::split(text, ',')) {
        const std::size_t colon = fault.find(':');
        if (colon == std::string::npos) {
            reject(option, text, "it is FRAME:COUNT, several with commas");
        }
        lost.push_back({accepted(read_whole(option, fault.substr(0, colon))),
                        accepted(read_whole(option, fault.substr(colon + 1)))});
    }
    return lost;
}

std::string lost_text(const std::vector<LostSamples>& lost) {
    return joined(lost, ",", [](const LostSamples& fault) {
        return integer_text(fault.frame) + ":" + integer_text(fault.count);
    });
}

void add_number(CLI::App& app, const std::string& name, double& target,
                const std::string& placeholder, const std::string& help) {
    add_value(app, name, placeholder, help,
              [&target](const std::string& option, const std::string& text) {
                  target = accepted(read_number(option, text));
              });
}

void add_hum_and_faults(CLI::App& app, FreeDecay& decay) {
    add_value(app, "--hum", "X,HZ,RAD", "Mains in both channels: amplitude, frequency, phase",
              [&decay](const auto& option, const auto& text) {
                  const auto hum =
                      accepted(read_numbers(option, text, 3, "it is three numbers X,HZ,RAD"));
                  decay.hum = hum[0];
                  decay.hum_hz = hum[1];
                  decay.hum_phase = hum[2];
              });
    app.add_option_function<std::vector<std::string>>(
           "--mode-beside",
           [&decay](const std::vector<std::string>& modes) {
               for (const std::string& mode : modes) {
                   const auto x =
                       accepted(read_numbers("--mode-beside", mode, 6,
                                             "it is six numbers HZ,A_C,A_D,PHASE_C,PHASE_D,TAU"));
                   decay.modes_beside.push_back({x[0], x[1], x[2], x[3], x[4], x[5]});
               }
           },
           "Another mode in both channels: A cos(2 pi HZ t - PHASE) e^(-t/TAU); once for each")
        ->type_name("HZ,A_C,A_D,PHASE_C,PHASE_D,TAU")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_value(
        app, "--lose", "FRAME:COUNT,...",
        "Cut COUNT samples out from FRAME on; a negative COUNT: record them twice",
        [&decay](const auto& option, const auto& text) { decay.lost = lost_value(option, text); });
}

// The decay as (option name without dashes, value text), in the order of the help.
std::vector<std::pair<std::string, std::string>> decay_list(const FreeDecay& decay) {
    std::vector<std::pair<std::string, std::string>> list;
    list.reserve(decay_options.size());
    for (const DecayOption& option : decay_options) {
        list.emplace_back(option.name, round_trip_text(decay.*option.member));
    }
    list.emplace_back("offset", offset_text(decay));
    if (decay.hum != 0) {
        list.emplace_back("hum", joined({decay.hum, decay.hum_hz, decay.hum_phase}));
    }
    for (const ModeBeside& x : decay.modes_beside) {
        list.emplace_back("mode-beside",
                          joined({x.f_hz, x.a_C, x.a_D, x.phase_C, x.phase_D, x.tau_s}));
    }
    if (!decay.lost.empty()) {
        list.emplace_back("lose", lost_text(decay.lost));
    }
    list.emplace_back("bits", std::to_string(decay.bits));
    list.emplace_back("full-scale", round_trip_text(decay.full_scale));
    list.emplace_back("seed", std::to_string(decay.seed));
    return list;
}

// The amplitudes of a truth in other units.
void scale_amplitudes(Track& track, double factor) {
    for (const SlowVariable variable : all_slow_variables) {
        if (info(variable).quantity == Quantity::amplitude) {
            for (double& value : track.values(variable)) {
                value *= factor;
            }
        }
    }
}

Status fill_truth(OutputFile& file, TrackFormat format, const SimulateRequest& request,
                  double full_scale, bool fractions_of_full_scale, const JobControl& job) {
    auto truth = TRY(true_track(request.decay, request.window));
    std::vector<std::string> header{program, "truth of a simulated decay"};
    for (const auto& [name, value] : decay_list(request.decay)) {
        header.push_back(name + ": " + value);
    }
    if (fractions_of_full_scale) {
        // The samples read back from PCM are fractions of full scale, and so is their truth.
        scale_amplitudes(truth, 1 / full_scale);
        header.push_back("amplitudes: fractions of the full scale " + round_trip_text(full_scale));
    }
    return write_track(file, format, truth, header, job);
}

// Options that change nothing beside the others.
std::vector<Diagnostic> without_effect(const SimulateRequest& request) {
    const FreeDecay& decay = request.decay;
    const FreeDecay usual;
    std::vector<Diagnostic> found;
    const auto check = [&found](bool idle, const char* option, const char* why) {
        if (idle) {
            found.push_back({DiagnosticKind::option_without_effect, {option, why}});
        }
    };
    check(decay.full_scale != 0 && decay.bits == 0, "--full-scale", "it is that of --bits");
    check(request.window != SimulateRequest{}.window && request.truth.empty(), "--window",
          "it is that of --truth");
    const bool noisy = decay.noise != 0 || decay.carrier_noise != 0 ||
                       decay.modulation_noise != 0 || decay.phase_noise_rad != 0;
    check(decay.seed != usual.seed && !noisy, "--seed", "there is no noise");
    check(decay.settling_time_s != usual.settling_time_s && decay.settling_hz == 0,
          "--settling-time", "there is no --settling");
    check(decay.bryan != usual.bryan && decay.omega_rad_s == 0, "--bryan", "there is no --omega");
    check(decay.theta_w != usual.theta_w && decay.split_hz == 0, "--theta-w",
          "there is no --split");
    check(decay.theta_tau != usual.theta_tau && decay.damping_anisotropy_per_s == 0, "--theta-tau",
          "there is no --damping-anisotropy");
    return found;
}

}  // namespace

void add_simulate_options(CLI::App& app, SimulateRequest& request) {
    FreeDecay& decay = request.decay;
    app.add_option("-o,--output", request.output,
                   "Samples, by the ending: .wav (64-bit float; PCM with --bits), .csv, .npy, "
                   ".mat; - for CSV on standard output")
        ->type_name("FILE")
        ->required();
    add_value(app, "--truth", "FILE", "The true track, as that of analyze; - for standard output",
              [&request](const auto&, const auto& text) { request.truth = text; });
    add_value(app, "--window", "N", "Window of the truth, samples (default 60)",
              [&request](const auto& option, const auto& text) {
                  request.window = accepted(read_whole(option, text));
              });
    add_value(
        app, "--lock-in", "ORDER,BW,RATE",
        "Beside the samples, in FILE's name with .phasors.csv, their log by a lock-in at f0: RC "
        "stages, 1 to 8, 3 dB bandwidth and rows a second",
        [&request](const auto& option, const auto& text) {
            request.lock_in = accepted(read_lock_in(option, text, &request.lock_in_rate_hz));
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
                  const auto offsets =
                      accepted(read_numbers(option, text, 2, "it is two numbers C,D"));
                  decay.offset_c = offsets[0];
                  decay.offset_d = offsets[1];
              });
    add_hum_and_faults(app, decay);
    add_value(app, "--bits", "B", "Quantise to B bits, 2 to 32 (default: do not)",
              [&decay](const auto& option, const auto& text) {
                  const std::int64_t bits = accepted(read_whole(option, text));
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

Status run_simulate(const SimulateRequest& request, Log& log, std::stop_token stop) {
    const double begun = seconds_now();
    const bool has_log = request.lock_in.order > 0;
    const std::string log_path =
        has_log ? std::filesystem::path(request.output).replace_extension("phasors.csv").string()
                : std::string();
    if (has_log && request.output == "-") {
        return refused_value("--lock-in", "-o -", "its log needs the name of a file");
    }
    TRY(check_outputs({{"-o", request.output, "the samples go there already"},
                       {"--truth", request.truth, "the truth goes there already"},
                       {"--lock-in", log_path, ""}},
                      {}));
    const auto format =
        TRY(request.output == "-" ? SampleFormat::csv : sample_format(request.output));
    const auto truth_format =
        TRY(request.truth == "-" ? TrackFormat::csv : track_format(request.truth));
    auto output = TRY(open_output(request.output, silent_job(stop)));
    auto truth = TRY(open_named(request.truth, silent_job(stop)));
    auto phasors = TRY(open_named(log_path, silent_job(stop)));
    const FreeDecay& decay = request.decay;
    // The signals are made anew for each time that they are gone through.
    const bool peak_unknown = decay.bits > 0 && decay.full_scale == 0;
    const int runs = (format == SampleFormat::mat ? 2 : 1) + (peak_unknown ? 1 : 0);
    const JobControl whole = job_of(stop, log);
    int done = 0;
    const JobControl job(stop, [&](double fraction) {
        whole.report((done + fraction) / runs);
        done += fraction == 1 ? 1 : 0;
    });
    const auto full_scale = TRY(find_full_scale(decay, job));
    const bool pcm = format == SampleFormat::wav && decay.bits > 0;
    std::optional<SoftwareLockIn> lock_in;
    const auto run = [&](const SampleSink& sink) {
        if (!has_log) {
            return simulate(decay, full_scale, sink, job);
        }
        const auto samples = std::llround(decay.rate_hz / request.lock_in_rate_hz);
        lock_in.emplace(request.lock_in, decay.f0_hz, decay.rate_hz,
                        std::max<std::int64_t>(samples, 1));
        const auto both = [&](std::span<const double> c, std::span<const double> d) {
            lock_in->take(c, d);
            return sink(c, d);
        };
        return simulate(decay, full_scale, both, job);
    };
    std::vector<OutputFile*> outputs{&output};
    if (phasors) {
        outputs.push_back(&*phasors);
    }
    if (truth) {
        outputs.push_back(&*truth);
    }
    const auto write_all = [&]() -> Status {
        TRY(write_stream(output, format,
                         {frame_count(decay), decay.rate_hz, decay.bits, full_scale, run}));
        if (truth) {
            TRY(fill_truth(*truth, truth_format, request, full_scale, pcm, silent_job(stop)));
        }
        if (phasors) {
            TRY(phasors->write(lock_in->table()));
        }
        return OutputFile::commit_together(outputs);
    };
    if (const Status written = write_all(); !written) {
        Error error = written.error();
        for (const OutputFile* file : outputs) {
            error = file->as_it_stands(error);
        }
        return error;
    }
    log.warnings(without_effect(request));
    if (request.timing) {  // the samples are made while they are written
        say_timing({{"read_s", 0.0},
                    {"carrier_s", 0.0},
                    {"estimate_s", 0.0},
                    {"write_s", seconds_now() - begun},
                    {"windows", 0},
                    {"threads", 1}});
    }
    return {};
}

}  // namespace vybeg::cli
