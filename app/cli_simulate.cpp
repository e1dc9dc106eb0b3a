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
#include "core/track/track.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vybeg::cli {
namespace {

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
    for (const SettingRow<FreeDecay>& row : decay_settings()) {
        if (row.name == mode_beside_option) {
            for (const ModeBeside& x : request.decay.modes_beside) {
                header.push_back(row.name + ": " +
                                 joined({x.f_hz, x.a_C, x.a_D, x.phase_C, x.phase_D, x.tau_s}));
            }
        } else if (const std::string value = row.text(request.decay); !value.empty()) {
            header.push_back(row.name + ": " + value);
        }
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
    add_text(app, "-o,--output", "FILE", request.output,
             "Samples, by the ending: .wav (64-bit float; PCM with --bits), .csv, .npy, "
             ".mat; - for CSV on standard output")
        ->required();
    add_text(app, "--truth", "FILE", request.truth,
             "The true track, as that of analyze; - for standard output");
    add_value(app, "--window", "N",
              "Window of the truth, samples (default " + integer_text(request.window) + ")",
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
    // Options act in the order of their definition: typed ones change the demo.
    app.add_flag_callback(
        "--demo", [&decay] { decay = demo_decay(); },
        "The article's case, 28 s at 33333 Hz: a swing of the quadrature, a turn through an axis, "
        "noise of 60 dB. Other options change it");
    for (const SettingRow<FreeDecay>& row : decay_settings()) {
        if (row.name != mode_beside_option) {
            add_setting(app, row, decay);
            continue;
        }
        app.add_option_function<std::vector<std::string>>(
               row.option(),
               [&row, &decay](const std::vector<std::string>& modes) {
                   for (const std::string& mode : modes) {
                       if (const Status read = row.read(mode, decay); !read) {
                           refuse(read.error());
                       }
                   }
               },
               row.help)
            ->type_name(row.placeholder)
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    }
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
        TRY(write_samples(output, format,
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
    // The samples are made while they are written.
    log.timing({.threads = 1}, seconds_now() - begun, 0);
    return {};
}

}  // namespace vybeg::cli
