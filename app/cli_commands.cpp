#include "app/cli_commands.h"

#include "app/cli_simulate_options.h"
#include "app/cli_support.h"
#include "core/analysis/analyse.h"
#include "core/analysis/analyse_log.h"
#include "core/analysis/analysis.h"
#include "core/analysis/idle_options.h"
#include "core/analysis/inspect.h"
#include "core/analysis/setting_table.h"
#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/base/finding.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/base/read_value.h"
#include "core/batch/identify_set.h"
#include "core/output/output_paths.h"
#include "core/output/recording_json.h"
#include "core/output/sample_files.h"
#include "core/output/track_file.h"
#include "core/output/track_header.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/file_changes.h"
#include "core/simulation/simulate.h"
#include "core/simulation/software_lock_in.h"
#include "core/simulation/true_track.h"
#include "core/track/track.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vybeg::cli {
namespace {

// ", sd 0.003 Hz", where the digits of the file leave the rate open.
std::string rate_sd_text(const Recording& recording) {
    return recording.rate_relative_sd > 0
               ? ", sd " + short_text(recording.rate_relative_sd * recording.rate_hz, 2) + " Hz"
               : "";
}

// The worst findings, each kind once; `verbose`: all of them, each place by itself.
std::string check_text(const std::vector<Diagnostic>& diagnostics, bool verbose) {
    const auto line = [](const Diagnostic& of, const std::string& sentence) {
        return (severity(of.kind) == Severity::note ? "note      " : "check     ") + sentence +
               "\n";
    };
    std::string text;
    const std::vector<Finding> findings = findings_of(diagnostics);
    for (std::size_t k = 0; k < findings.size() && (verbose || k < most_shown); ++k) {
        const Finding& finding = findings[k];
        text += line(finding.diagnostic, verbose ? english(finding.diagnostic) : english(finding));
        for (std::size_t i = 0; verbose && i < finding.more.size(); ++i) {
            text += line(finding.more[i], english(finding.more[i]));
        }
    }
    if (!verbose && findings.size() > most_shown) {
        text += "check     " + std::to_string(findings.size() - most_shown) + " more: --verbose\n";
    }
    return text.empty() ? "check     nothing found\n" : text;
}

std::string described(const Recording& recording, const std::string& sha256,
                      const std::vector<Diagnostic>& diagnostics, bool verbose) {
    std::string text = "file      " + plain_text(recording.path.string()) + "\nformat    " +
                       english(recording.format) + "\nlength    " +
                       short_text(recording.seconds(), 12) + " s, " +
                       integer_text(recording.frames()) + " frames\nrate      " +
                       short_text(recording.rate_hz, 12) + " Hz (" +
                       rate_origin_name(recording.rate_from) + rate_sd_text(recording) + ")\n";
    for (std::size_t i = 0; i < recording.channels.size(); ++i) {
        const Channel& channel = recording.channels[i];
        text += "channel   " + std::to_string(i + 1) + ": " + channel.name;
        text += channel.unit.empty() ? "\n" : ", " + channel.unit + "\n";
    }
    if (!recording.start.empty()) {
        text += "start     " + recording.start + "\n";
    }
    text += "sha256    " + sha256 + "\n";
    return text + check_text(diagnostics, verbose);
}

// `windows`: of an analysis.
void say_timing(const Timing& timing, double write_s, std::int64_t windows) {
    const nlohmann::ordered_json line{{"read_s", timing.read_s},
                                      {"carrier_s", timing.carrier_s},
                                      {"estimate_s", timing.estimate_s},
                                      {"write_s", write_s},
                                      {"windows", windows},
                                      {"threads", timing.threads}};
    std::fputs((line.dump() + "\n").c_str(), stderr);
}

// CSV on standard output.
Result<TrackFormat> format_of_track(const std::string& path) {
    return path == "-" ? TrackFormat::csv : track_format(path);
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

Status run_info(const InfoRequest& request, Log& log, std::stop_token stop) {
    const double begun = seconds_now();
    const auto recording = TRY(open_recording(request.input, request.open, silent_job(stop)));
    const auto sha256 = TRY(recording_sha256(recording, silent_job(stop)));
    const auto faults = TRY(inspect(recording, {}, job_of(stop, log)));
    TRY(unchanged(recording));
    log.warnings(without_effect(request.open, recording));
    const double read = seconds_now();
    TRY(write_text(request.json ? recording_json(recording, sha256, faults.findings)
                                : described(recording, sha256, faults.findings, request.verbose),
                   silent_job(stop)));
    if (request.timing) {
        say_timing({.read_s = read - begun, .threads = threads_of(0)}, seconds_now() - read, 0);
    }
    return {};
}

namespace {

// Of a log in place of a recording; all that needs samples is known to be absent.
Status write_log_track(const AnalyzeRequest& request, TrackFormat format, OutputFile& output,
                       Log& log, const JobControl& job) {
    const double begun = seconds_now();
    const auto analysis =
        TRY(analyse_log(request.input, request.open, request.log, request.settings, job));
    const auto sha256 = TRY(file_sha256(request.input, job));
    log.warnings(std::vector<NamedWarnings>{{"", analysis.diagnostics},
                                            {"", without_effect(request.settings, request.log)}});
    const double analysed = seconds_now();
    TRY(write_track(output, format, analysis.track,
                    track_header(program, request.input, sha256, request.log, analysis), job));
    TRY(output.commit());
    if (request.timing) {
        Timing timing = analysis.timing;
        timing.estimate_s = analysed - begun - timing.read_s;
        say_timing(timing, seconds_now() - analysed, analysis.plan.count);
    }
    return {};
}

}  // namespace

Status run_analyze(const AnalyzeRequest& request, Log& log, std::stop_token stop) {
    TRY(validate(request.settings));
    TRY(check_outputs({{"-o", request.output, ""}},
                      {{request.input, "it is the recording itself"}}));
    const auto format = TRY(format_of_track(request.output));
    if (request.log.given()) {
        auto output = TRY(open_output(request.output, silent_job(stop)));
        return write_log_track(request, format, output, log, job_of(stop, log));
    }
    const double begun = seconds_now();
    const auto recording = TRY(open_recording(request.input, request.open, silent_job(stop)));
    HashBeside hash(recording, request.settings.threads, stop);
    const double opened = seconds_now();
    auto output = TRY(open_output(request.output, silent_job(stop)));
    TrackWriter rows(output, format, silent_job(stop));
    double write_s = 0;
    const TrackSink sink = [&](const Track& next) {
        const double before = seconds_now();
        const Status written = rows.append(next);
        write_s += seconds_now() - before;
        return written;
    };
    const Result<AnalysisSummary> analysis =
        analyse(recording, request.settings, sink, job_of(stop, log));
    const Status still = unchanged(recording);
    if (!analysis || !still) {
        log.warnings(recording.diagnostics);
        return output.as_it_stands(still ? analysis.error() : still.error());
    }
    log.warnings(std::vector<NamedWarnings>{{"", analysis->diagnostics},
                                            {"", without_effect(request.settings)},
                                            {"", without_effect(request.settings, request.log)},
                                            {"", without_effect(request.open, recording)}});
    const double analysed = seconds_now();
    const Result<std::string> sha256 = hash.get();
    if (!sha256) {
        return output.as_it_stands(sha256.error());
    }
    Status written =
        rows.finish(track_header(program, recording, *sha256, *analysis), analysis->flagged);
    if (written) {
        written = output.commit();
    }
    if (!written) {
        return output.as_it_stands(written.error());
    }
    write_s += seconds_now() - analysed;
    if (request.timing) {
        Timing timing = analysis->timing;
        timing.read_s += opened - begun;
        say_timing(timing, write_s, analysis->plan.count);
    }
    return {};
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
    const auto truth_format = TRY(format_of_track(request.truth));
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
        say_timing({.threads = 1}, seconds_now() - begun, 0);
    }
    return {};
}

}  // namespace vybeg::cli
