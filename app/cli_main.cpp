#include "app/cli_commands.h"
#include "app/cli_support.h"
#include "app/command_line.h"
#include "app/process_guard.h"
#include "core/analysis/setting_table.h"
#include "core/base/error.h"
#include "core/batch/batch_sets.h"
#include "core/drift/drift_settings.h"
#include "core/recording/samples/open_table.h"
#include "core/simulation/simulate.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <span>
#include <string>
#include <string_view>

namespace {

using namespace vybeg;
using namespace vybeg::cli;

void add_log_options(CLI::App& app, LogOptions& options, bool with_verbose = true) {
    app.add_flag("--quiet", options.quiet, "Neither progress nor warnings on standard error");
    app.add_flag("--json-log", options.json,
                 "Standard error as one JSON object per line: errors, warnings, progress");
    if (with_verbose) {
        app.add_flag("--verbose", options.verbose,
                     "All warnings, and notes, each by itself (default: the three worst)");
    }
}

void add_input(CLI::App& app, std::string& input) {
    add_text(app, "FILE", "", input,
             "The recording: WAV, FLAC, AIFF, CSV, raw samples; recognised by content")
        ->required();
}

void add_timing(CLI::App& app, bool& timing) {
    app.add_flag("--timing", timing, "Last line of standard error: where the time went, JSON, s");
}

void add_database(CLI::App& app, std::string& database) {
    add_text(app, "--database", "FILE", database,
             "Also the result of each set, into a database (SQLite) that many runs share");
}

void add_drift_options(CLI::App& app, DriftRequest& request) {
    app.add_option("LOG", request.inputs, "Whole-angle logs of one gyro: text, NPZ, MAT or HDF5")
        ->type_name("")
        ->required();
    add_settings(app, drift_settings(), request.settings);
    add_text(app, "-o,--output", "FILE", request.output,
             "The drift by angle, CSV, or the result, JSON, by the ending; - for CSV on "
             "standard output");
    app.add_flag("--json", request.json,
                 "The result on standard output, JSON, in place of the summary");
}

void add_compare_options(CLI::App& app, CompareOptions& options) {
    add_value(app, "--f-limit", "PPM",
              "Frequencies count as changed beyond this, ppm: they follow the temperature (default "
              "30)",
              [&options](const auto& option, const auto& text) {
                  options.f_limit_ppm = accepted(read_number(option, text));
                  if (options.f_limit_ppm < 0) {
                      reject(option, text, "it cannot be negative");
                  }
              });
    add_value(app, "--limit", "NAME=X[,NAME=X]",
              "Smaller changes count as none, significant or not: in the parameter's unit, or "
              "relative as in tau=0.5%,f_mean=10ppm",
              [&options](const auto&, const auto& text) {
                  options.limits = accepted(read_practical_limits(text));
              });
}

void add_batch_options(CLI::App& app, BatchRequest& request, bool& timing) {
    CLI::Option* const list =
        add_text(app, "LIST", "", request.list,
                 "Measurement list, CSV, or a folder in which each file is a set of its own");
    app.add_option_function<std::string>(
           "--watch",
           [&request](const std::string& folder) {
               request.list = folder;
               request.watch = true;
           },
           "In place of LIST: whatever comes to this folder, until it is interrupted; each row on "
           "standard output, too")
        ->type_name("DIR")
        ->excludes(list);
    add_text(app, "-o,--output", "RESULTS.csv", request.output,
             "The table, CSV: a row for each set; - for standard output")
        ->required();
    add_text(app, "--json", "DIR", request.json,
             "Also the result of each set, as identify writes it");
    add_text(app, "--passport", "DIR", request.passports,
             "Compare each set with the passport of its gyro, DIR/GYRO.json");
    add_text(app, "--passports-out", "DIR", request.new_passports,
             "Also a passport of each set: DIR/GYRO.json, or DIR/SET.json where the gyro has "
             "several sets");
    add_text(app, "--limits", "LIMITS.csv", request.limits,
             "Limits, CSV: parameter, least, greatest, gyro_type; adds the columns passed and "
             "failed_by, by the value with its expanded uncertainty");
    app.add_flag("--excel", request.excel,
                 "The table for table programs with a decimal comma: semicolons, no comment lines");
    add_database(app, request.database);
    add_value(app, "--jobs", "N", "Sets computed at once (default 1)",
              [&request](const auto& option, const auto& text) {
                  constexpr int most_jobs = 1024;
                  const std::int64_t jobs = accepted(read_whole(option, text));
                  if (jobs < 1 || jobs > most_jobs) {
                      reject(option, text, "it must be 1 to 1024");
                  }
                  request.jobs = static_cast<int>(jobs);
              });
    app.add_flag("--resume", request.resume,
                 "Keep the rows of an interrupted run whose files and options are the same");
    add_text(app, "--only", "NAME", request.only, "This set alone");
    add_analysis_options(app, identify_settings(), request.settings);
    add_settings(app, open_settings(), request.open);
    add_compare_options(app, request.compare);
    add_timing(app, timing);
}

// What identify and compare share.
void add_identification(CLI::App& app, IdentifyRequest& request, bool& timing) {
    app.add_option("FILE", request.inputs,
                   "The recordings of one resonator, started at different angles")
        ->type_name("");
    CLI::Option* const list =
        add_text(app, "--list", "LIST.csv", request.list,
                 "Measurement list, CSV: a row for each recording, with its options")
            ->excludes("FILE");
    add_text(app, "--set", "NAME", request.set, "The set of the list (default: its only one)")
        ->needs(list);
    add_text(app, "-o,--output", "RESULT.json", request.output,
             "The result, JSON; - for standard output (default: a summary there)");
    add_analysis_options(app, identify_settings(), request.settings);
    add_settings(app, open_settings(), request.open);
    add_timing(app, timing);
}

bool asks_for_json(std::span<char*> words) {
    return std::ranges::any_of(
        words, [](const char* word) { return std::string_view(word) == "--json-log"; });
}

int run(int argc, char** argv) {
    const InterruptGuard interrupt;
    const std::span words(argv, static_cast<std::size_t>(argc));
    // "help" and "help info" ask as "--help" and "info --help" do.
    std::string help = "--help";
    if (words.size() > 1 && std::string_view(words[1]) == "help") {
        words[1] = words.size() > 2 ? words[2] : help.data();
        words[words.size() > 2 ? 2 : 1] = help.data();
    }

    CLI::App app("Vybeg: standing waves in the free decay of a hemispherical resonator gyroscope.");
    app.name("vybeg-cli");
    app.set_version_flag("--version", program);
    app.require_subcommand(1);
    app.footer(
        "Amplitudes are in the recording's units, angles in rad (in a summary: degrees), "
        "frequencies in Hz.\n"
        "Exit status: 0 done, 2 wrong usage, 3 the input cannot be read, 4 the analysis is "
        "impossible,\n5 the output cannot be written, 130 interrupted.");

    LogOptions log_options;
    InfoRequest info;
    CLI::App* const info_command = app.add_subcommand("info", "What a recording is");
    add_input(*info_command, info.input);
    info_command->add_flag("--json", info.json, "As JSON");
    add_settings(*info_command, open_settings(), info.open);
    add_timing(*info_command, log_options.timing);
    add_log_options(*info_command, log_options);

    AnalyzeRequest analyze;
    CLI::App* const analyze_command =
        app.add_subcommand("analyze", "The slow variables of a recording over time");
    add_input(*analyze_command, analyze.input);
    add_text(*analyze_command, "-o,--output", "TRACK", analyze.output,
             "The track: .csv, .mat, .h5 or .npz by its ending; - for CSV on standard output")
        ->required();
    add_analysis_options(*analyze_command, analysis_settings(), analyze.settings);
    add_settings(*analyze_command, open_settings(), analyze.open);
    add_settings(*analyze_command, log_settings(), analyze.log);
    add_log_options(*analyze_command, log_options);
    add_timing(*analyze_command, log_options.timing);

    IdentifyRequest identification;  // of the one or the other
    CLI::App* const identify_command = app.add_subcommand(
        "identify", "The resonator behind one or several recordings of its free decay");
    add_identification(*identify_command, identification, log_options.timing);
    add_text(*identify_command, "--passport", "PASSPORT.json", identification.new_passport,
             "Also write the gyro's passport, to compare with later");
    add_database(*identify_command, identification.database);
    add_log_options(*identify_command, log_options);

    CLI::App* const compare_command =
        app.add_subcommand("compare", "Identify the resonator and compare it with its passport");
    add_text(*compare_command, "PASSPORT", "", identification.old_passport,
             "A passport that identify has written")
        ->required();
    add_identification(*compare_command, identification, log_options.timing);
    add_compare_options(*compare_command, identification.compare);
    add_log_options(*compare_command, log_options);

    DriftRequest drift;
    CLI::App* const drift_command = app.add_subcommand(
        "drift", "The drift of a wave that is held and turns, from whole-angle logs");
    add_drift_options(*drift_command, drift);
    add_log_options(*drift_command, log_options);

    BatchRequest batch;
    batch.program = program;
    CLI::App* const batch_command =
        app.add_subcommand("batch", "The resonators of a measurement list, as a table");
    add_batch_options(*batch_command, batch, log_options.timing);
    add_log_options(*batch_command, log_options);

    SimulateRequest simulation;
    CLI::App* const simulate_command =
        app.add_subcommand("simulate", "A recording from the equations of motion, and its truth");
    add_simulate_options(*simulate_command, simulation);
    add_timing(*simulate_command, log_options.timing);
    add_log_options(*simulate_command, log_options, false);

    let_repeated_options_parse(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {  // --help, --version
            const Status written = write_answer(app, error);
            return written ? 0 : Log({.quiet = true}).fail(written.error());
        }
        // The parse has failed, and with it perhaps its knowledge of --json-log.
        return Log({.json = asks_for_json(words)}).fail_usage(parse_fault(app, error, words));
    }

    // A simulation has no warnings but of options, and says each.
    log_options.verbose = log_options.verbose || simulate_command->parsed();
    Log log(log_options);
    if (const std::string fault = usage_fault(app, words); !fault.empty()) {
        return log.fail_usage(fault);
    }
    if (const Status enough = check_stack(); !enough) {
        return log.fail(enough.error());
    }
    const bool identifies = identify_command->parsed() || compare_command->parsed();
    if (identifies && identification.inputs.empty() && identification.list.empty()) {
        return log.fail_usage("FILE or --list is required.");
    }
    if (batch_command->parsed()) {
        for (const char* option : {"--f-limit", "--limit"}) {
            if (batch.passports.empty() && batch_command->count(option) > 0) {
                log.warnings({{DiagnosticKind::option_without_effect,
                               {option, "there is no --passport to compare with"}}});
            }
        }
        if (batch.watch && !batch.only.empty()) {
            log.warnings({{DiagnosticKind::option_without_effect,
                           {"--only", "--watch computes every set that comes"}}});
        }
        if (batch.list.empty()) {
            return log.fail_usage("LIST is required.");
        }
    }
    const std::stop_token stop = interrupt.token();
    const Status done = info_command->parsed()       ? run_info(info, log, stop)
                        : analyze_command->parsed()  ? run_analyze(analyze, log, stop)
                        : drift_command->parsed()    ? run_drift(drift, log, stop)
                        : batch_command->parsed()    ? run_batch(batch, log, stop)
                        : simulate_command->parsed() ? run_simulate(simulation, log, stop)
                                                     : run_identify(identification, log, stop);
    return done ? 0 : log.fail(done.error());
}

}  // namespace

int main(int argc, char** argv) {
    open_missing_descriptors();
    end_with_a_sentence();
    try {
        return run(argc, argv);
    } catch (...) {
        const bool json = asks_for_json(std::span(argv, static_cast<std::size_t>(argc)));
        return Log({.json = json}).fail(error_of(std::current_exception()));
    }
}
