#include "app/analysis_options.h"
#include "app/cli_commands.h"
#include "app/cli_interrupt.h"
#include "app/cli_log.h"
#include "app/cli_simulate_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <span>
#include <string_view>

namespace {

using namespace vybeg;
using namespace vybeg::cli;

struct LogOptions {
    bool quiet = false;
    bool json = false;
};

void add_log_options(CLI::App& app, LogOptions& options) {
    app.add_flag("--quiet", options.quiet, "Neither progress nor warnings on standard error");
    app.add_flag("--json-log", options.json,
                 "Standard error as one JSON object per line: errors, warnings, progress");
}

void add_input(CLI::App& app, std::string& input) {
    app.add_option("FILE", input,
                   "The recording: WAV, FLAC, AIFF, CSV, raw samples; recognised by content")
        ->type_name("")
        ->required();
}

// What is wrong with the command line, as one sentence: CLI11's own words where they are clear.
std::string sentence(const CLI::ParseError& error, std::span<char*> words) {
    std::string text = error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        return text.substr(0, text.find(':')) + " needs a value.";
    }
    const bool without_command = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr &&
                                 text.starts_with("A subcommand");
    if (without_command && words.size() > 1 && words[1][0] != '-') {
        return "there is no subcommand \"" + std::string(words[1]) + "\".";
    }
    std::ranges::replace(text, '\n', ' ');
    return text.ends_with('.') ? text : text + ".";
}

}  // namespace

int main(int argc, char** argv) {
    const InterruptGuard interrupt;

    CLI::App app("Vybeg: standing waves in the free decay of a hemispherical resonator gyroscope.");
    app.name("vybeg-cli");
    app.set_version_flag("--version", program);
    app.require_subcommand(1);
    app.footer(
        "Amplitudes are in the recording's units, angles in rad, frequencies in Hz.\n"
        "Exit status: 0 done, 2 wrong usage, 3 the input cannot be read, 4 the analysis is "
        "impossible,\n5 the output cannot be written, 130 interrupted.");

    LogOptions log_options;
    InfoRequest info;
    CLI::App* const info_command = app.add_subcommand("info", "What a recording is");
    add_input(*info_command, info.input);
    info_command->add_flag("--json", info.json, "As JSON");
    add_open_options(*info_command, info.open);
    add_log_options(*info_command, log_options);

    AnalyzeRequest analyze;
    CLI::App* const analyze_command =
        app.add_subcommand("analyze", "The slow variables of a recording over time, as CSV");
    add_input(*analyze_command, analyze.input);
    analyze_command
        ->add_option("-o,--output", analyze.output, "The track, CSV; - for standard output")
        ->type_name("TRACK.csv")
        ->required();
    add_analysis_options(*analyze_command, analyze.settings);
    add_open_options(*analyze_command, analyze.open);
    add_log_options(*analyze_command, log_options);
    analyze_command->add_flag("--timing", analyze.timing,
                              "Last line of standard error: where the time went, JSON, s");

    SimulateRequest simulation;
    CLI::App* const simulate_command =
        app.add_subcommand("simulate", "A recording from the equations of motion, and its truth");
    add_simulate_options(*simulate_command, simulation);
    add_log_options(*simulate_command, log_options);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {  // --help, --version
            return app.exit(error);
        }
        // The parse has failed, and with it perhaps its knowledge of --json-log.
        const std::span words(argv, static_cast<std::size_t>(argc));
        const bool json =
            std::ranges::find(words, std::string_view("--json-log"), [](const char* word) {
                return std::string_view(word);
            }) != words.end();
        return Log(json, false).fail_usage(sentence(error, words));
    }

    Log log(log_options.json, log_options.quiet);
    if (info_command->parsed()) {
        return run_info(info, log, interrupt.token());
    }
    if (analyze_command->parsed()) {
        return run_analyze(analyze, log, interrupt.token());
    }
    return run_simulate(simulation, log, interrupt.token());
}
