#include "app/cli_commands.h"

#include "core/analysis/analyse.h"
#include "core/analysis/analyse_logs.h"
#include "core/analysis/analysis.h"
#include "core/analysis/ignored_options.h"
#include "core/analysis/setting_table.h"
#include "core/base/diagnostic.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/batch/identify_set.h"
#include "core/output/identify_json.h"
#include "core/output/output_file.h"
#include "core/output/track_file.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/recording.h"
#include "core/track/track.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace vybeg::cli {
namespace {

// ", sd 0.003 Hz", where the digits of the file leave the rate open.
std::string rate_sd_text(const Recording& recording) {
    return recording.rate_relative_sd > 0
               ? ", sd " + short_text(recording.rate_relative_sd * recording.rate_hz, 2) + " Hz"
               : "";
}

// A number as well known as the rate, without digits beyond its standard deviation.
std::string told_text(const Recording& recording, double value) {
    constexpr double most = 12;
    const double relative = recording.rate_relative_sd;
    const double digits = relative > 0 ? std::ceil(-std::log10(relative)) + 1 : most;
    return short_text(value, static_cast<int>(std::clamp(digits, 3.0, most)));
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
                       told_text(recording, recording.seconds()) + " s, " +
                       integer_text(recording.frames()) + " frames\nrate      " +
                       told_text(recording, recording.rate_hz) + " Hz (" +
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
    Timing timing = analysis.timing;
    timing.estimate_s = analysed - begun - timing.read_s;
    log.timing(timing, seconds_now() - analysed, analysis.plan.count);
    return {};
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
                                : described(recording, sha256, faults.findings, log.verbose()),
                   silent_job(stop)));
    log.timing({.read_s = read - begun, .threads = threads_of(0)}, seconds_now() - read, 0);
    return {};
}

Status run_analyze(const AnalyzeRequest& request, Log& log, std::stop_token stop) {
    TRY(validate(request.settings));
    std::vector<InputPath> inputs{{request.input, "it is the recording itself"}};
    add_recording_files(inputs, request.input, request.open);
    TRY(check_outputs({{"-o", request.output, ""}}, inputs));
    const auto format =
        TRY(request.output == "-" ? TrackFormat::csv : track_format(request.output));
    if (request.log.given()) {
        auto output = TRY(open_output(request.output, silent_job(stop)));
        return write_log_track(request, format, output, log, job_of(stop, log));
    }
    const double begun = seconds_now();
    const auto recording = TRY(open_recording(request.input, request.open, silent_job(stop)));
    BackgroundHash hash(recording, request.settings.threads, stop);
    const double opened = seconds_now();
    auto output = TRY(open_output(request.output, silent_job(stop)));
    TrackSpool rows(output, silent_job(stop));
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
    rows.set_flagged(analysis->flagged);
    Status written =
        write_track(output, format, rows, track_header(program, recording, *sha256, *analysis), {});
    if (written) {
        written = output.commit();
    }
    if (!written) {
        return output.as_it_stands(written.error());
    }
    write_s += seconds_now() - analysed;
    Timing timing = analysis->timing;
    timing.read_s += opened - begun;
    log.timing(timing, write_s, analysis->plan.count);
    return {};
}

Status run_batch(const BatchRequest& request, Log& log, std::stop_token stop) {
    const double begun = seconds_now();
    std::vector<std::string> names;  // of the sets
    std::size_t done = 0;
    std::int64_t computed = 0;
    IdentifyTiming spent;  // summed over the sets that were computed
    double write_s = 0;
    const auto begin = [&](const MeasurementList& list) {
        names.clear();
        done = 0;
        for (const MeasurementSet& set : list.sets) {
            names.push_back(set.name);
        }
    };
    const auto add = [&](const FinishedRow& row) {
        ++done;
        if (row.kept) {
            return;
        }
        ++computed;
        if (request.watch) {  // rows go to standard output as they come
            std::fputs((csv_row(row.fields) + "\n").c_str(), stdout);
            std::fflush(stdout);
        }
        spent.read_s += row.timing.read_s;
        spent.carrier_s += row.timing.carrier_s;
        spent.estimate_s += row.timing.estimate_s;
        spent.fit_s += row.timing.fit_s;
        spent.windows += row.timing.windows;
        spent.threads = row.timing.threads;
        write_s += row.write_s;
        const std::string& name = names[row.set];
        log.warnings(row.warnings, name);
        if (row.error) {
            log.fail(*row.error, name);
        }
        log.progress(static_cast<double>(done) / static_cast<double>(names.size()));
    };
    const BatchEvents events{[&](const auto& warnings) { log.warnings(warnings); }, begin, add,
                             seconds_now, [&](const auto& error) { log.fail(error); }};
    const Status finished = compute_batch(request, events, std::move(stop));
    if (finished) {
        log.timing({{"read_s", spent.read_s},
                    {"carrier_s", spent.carrier_s},
                    {"estimate_s", spent.estimate_s},
                    {"fit_s", spent.fit_s},
                    {"write_s", write_s},
                    {"batch_s", seconds_now() - begun},
                    {"sets", computed},
                    {"windows", spent.windows},
                    {"threads", spent.threads},
                    {"jobs", request.jobs}});
    }
    return finished;
}

}  // namespace vybeg::cli
