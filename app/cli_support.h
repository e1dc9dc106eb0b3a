#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/identify_settings.h"
#include "core/analysis/measurement_list.h"
#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/output/output_file.h"
#include "core/recording/samples/open_options.h"
#include "core/resonator/model/reason.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vybeg::cli {

// What the subcommands share.

struct LogOptions {
    bool quiet = false;    // errors alone
    bool json = false;     // --json-log
    bool verbose = false;  // people see all warnings, and notes
    bool timing = false;   // --timing
    const char* program = "vybeg-cli";
    const char* all_by = "--verbose";  // how people see all warnings
};

// What goes to standard error: sentences for people, or with --json-log one JSON object per line,
// {"level": "warning"|"error"|"progress", "code": .., "text": .., ..}.
class Log {
public:
    // Progress for people is shown on a terminal alone.
    explicit Log(const LogOptions& options);
    ~Log();

    bool verbose() const { return options_.verbose; }

    // The worst of them, each kind once. `set`: which they concern, where there are several.
    void warnings(std::span<const NamedWarnings> all, const std::string& set = {});
    void warnings(const std::vector<Diagnostic>& diagnostics);
    // Returns the exit status of the error. `about`: the set without a result, where others follow.
    int fail(const Error& error, const std::string& about = {});
    // A wrong command line: exit status 2.
    int fail_usage(const std::string& sentence);
    // Never called from two threads at once; fraction 0..1.
    void progress(double fraction);
    // Where the time went, as the last line, where it is asked for: names with seconds or counts.
    using Times = std::initializer_list<std::pair<const char*, std::variant<double, std::int64_t>>>;
    void timing(Times times) const;
    // Of an analysis, or of what has no windows.
    void timing(const Timing& timing, double write_s, std::int64_t windows) const;

private:
    void line(const std::string& text);
    void each_warning(std::span<const NamedWarnings> all, const std::string& set);
    void worst_warnings(std::span<const NamedWarnings> all, const std::string& set);
    void clear_progress();

    LogOptions options_;
    std::string begin_;  // of a line for people
    bool terminal_;
    int percent_ = -1;  // on the screen
};

// A monotonic clock, seconds.
double seconds_now();

// The longest part of the work, with its progress in the log.
JobControl job_of(std::stop_token stop, Log& log);
// Everything else: heard when it is to stop, without its own progress.
JobControl silent_job(std::stop_token stop);

// The file of an option; none where it is not given.
Result<std::optional<OutputFile>> open_named(const std::string& name, const JobControl& job);

// Recordings that a command line names: files, which are one set, or the sets of a list.
struct NamedRecordings {
    std::vector<std::string> inputs;
    std::string list;  // measurement list in place of the inputs; empty: none
    std::string set;   // of the list alone; empty: all, for a single result its only one
    OpenOptions open;
};

// Errors: those of read_measurement_list() and keep_set().
Result<MeasurementList> sets_of(const NamedRecordings& named, const IdentifySettings& settings,
                                Log& log);

// Text to standard output.
Status write_text(const std::string& text, const JobControl& job);

// --help and --version there, which may be read by something that ends before they do.
Status write_answer(const CLI::App& app, const CLI::ParseError& asked);

// "1.00034 ± 0.00005 Hz, u 0.0003", "(1.03 ± 0.03)e-6 Hz", or the reason. Angles for people are in
// degrees: one in rad becomes one.
std::string text_of(const Estimate& estimate, const std::string& unit);
// A line of a summary.
std::string line(const std::string& name, const std::string& text);
// Parameters for people have the names of the JSON without their units.
std::string label_of(std::string name);

// The lines of an owner, by the table of its parameters.
template <class Owner, class Parameters>
std::string lines_of(const Owner& owner, const Parameters& parameters) {
    std::string text;
    for (const auto& parameter : parameters) {
        text += line(label_of(parameter.name), text_of(owner.*parameter.member, parameter.unit));
    }
    return text;
}

}  // namespace vybeg::cli
