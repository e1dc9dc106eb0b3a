#include "app/cli_support.h"

#include "core/base/plain_text.h"
#include "core/batch/batch_sets.h"
#include "core/output/quantity_json.h"
#include "core/output/quantity_text.h"
#include "core/resonator/results/resonator_parameters.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <numbers>
#include <sstream>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace vybeg::cli {

double seconds_now() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

JobControl job_of(std::stop_token stop, Log& log) {
    return JobControl(
        std::move(stop), [&log](double fraction) { log.progress(fraction); }, seconds_now);
}

JobControl silent_job(std::stop_token stop) {
    return JobControl(std::move(stop), {}, seconds_now);
}

Result<std::optional<OutputFile>> open_named(const std::string& name, const JobControl& job) {
    if (name.empty()) {
        return std::optional<OutputFile>();
    }
    auto file = TRY(open_output(name, job));
    return std::optional(std::move(file));
}

Result<MeasurementList> sets_of(const NamedRecordings& named, const IdentifySettings& settings,
                                Log& log) {
    if (named.list.empty()) {
        MeasurementSet set{named.inputs.front(), {}, settings};
        for (const std::string& file : named.inputs) {
            set.recordings.push_back({file, file, named.open});
        }
        return MeasurementList{{}, {std::move(set)}, {}};
    }
    auto list = TRY(read_measurement_list(named.list, named.open, settings));
    log.warnings(list.warnings);
    if (!named.set.empty()) {
        TRY(keep_set(list, "--set", named.set));
    }
    return list;
}

Status write_text(const std::string& text, const JobControl& job) {
    OutputFile output = OutputFile::onto(STDOUT_FILENO, "standard output", job);
    TRY(output.write(text));
    return output.commit();
}

Status write_answer(const CLI::App& app, const CLI::ParseError& asked) {
    std::ostringstream text;
    app.exit(asked, text, text);
    return write_text(text.str(), JobControl());
}

Log::Log(const LogOptions& options)
    : options_(options),
      begin_(std::string(options.program) + ": "),
      terminal_(isatty(STDERR_FILENO)) {}

Log::~Log() {
    clear_progress();
}

// One write for one line: lines of several programs on one terminal stay whole.
void Log::line(const std::string& text) {
    clear_progress();
    std::fputs((text + "\n").c_str(), stderr);
}

void Log::clear_progress() {
    if (percent_ >= 0 && !options_.json) {
        std::fputs("\r      \r", stderr);
        percent_ = -1;
    }
}

void Log::warnings(std::span<const NamedWarnings> all, const std::string& set) {
    if (options_.quiet) {
        return;
    }
    if (options_.json || options_.verbose) {
        each_warning(all, set);
    } else {
        worst_warnings(all, set);
    }
}

void Log::warnings(const std::vector<Diagnostic>& diagnostics) {
    const NamedWarnings all{{}, diagnostics};
    warnings(std::span(&all, 1));
}

void Log::each_warning(std::span<const NamedWarnings> all, const std::string& set) {
    struct Each {
        std::string about;
        const Diagnostic* diagnostic;
        Severity severity;
    };
    std::vector<Each> each;
    for (const auto& [file, diagnostics] : all) {
        const bool both = !set.empty() && !file.empty() && file != set;
        const std::string about = both ? set + ", " + file : set.empty() ? file : set;
        for (const Diagnostic& diagnostic : diagnostics) {
            each.push_back({about, &diagnostic, severity(diagnostic.kind)});
        }
    }
    std::ranges::stable_sort(each, std::ranges::greater(), &Each::severity);
    for (const auto& [about, diagnostic, severity] : each) {
        const std::string text = english(*diagnostic);
        if (!options_.json) {
            line(begin_ + (severity == Severity::note ? "note: " : "warning: ") +
                 (about.empty() ? "" : plain_text(about) + ": ") + text);
            continue;
        }
        Json object{{"level", "warning"},
                    {"code", kind_name(diagnostic->kind)},
                    {"severity", severity_name(severity)},
                    {"text", text},
                    {"first_frame", diagnostic->first_frame},
                    {"count", diagnostic->count}};
        if (!about.empty()) {
            object["input"] = about;
        }
        line(json_line(object));
    }
}

void Log::worst_warnings(std::span<const NamedWarnings> all, const std::string& set) {
    const std::string of_set = set.empty() ? "" : plain_text(set) + ": ";
    std::vector<Finding> findings = findings_of(all);
    const std::size_t count = count_warnings(findings);
    for (std::size_t k = 0; k < std::min(count, most_shown); ++k) {
        // A set of one file has its name.
        std::erase(findings[k].about, set);
        line(begin_ + "warning: " + of_set + english(findings[k]));
    }
    if (count > most_shown) {
        line(begin_ + of_set + std::to_string(count - most_shown) + " more: " + options_.all_by);
    }
}

int Log::fail(const Error& error, const std::string& about) {
    const std::string text = english(error);
    const int status = exit_status(error.code);
    if (!options_.json) {
        // The text begins with the place of the error, of a set that may be its name.
        const bool named =
            error.where == about || std::filesystem::path(error.where).filename() == about;
        line(begin_ + (about.empty() || named ? "" : plain_text(about) + ": ") + text);
        return status;
    }
    Json object{
        {"level", "error"}, {"code", code_name(error.code)}, {"text", text}, {"status", status}};
    if (!about.empty()) {
        object["set"] = about;
    }
    line(json_line(object));
    return status;
}

int Log::fail_usage(const std::string& sentence) {
    const int status = exit_status(ErrorCode::setting_invalid);
    line(options_.json ? json_line({{"level", "error"},
                                    {"code", code_name(ErrorCode::setting_invalid)},
                                    {"text", sentence},
                                    {"status", status}})
                       : begin_ + sentence + " See vybeg-cli --help.");
    return status;
}

void Log::progress(double fraction) {
    const int percent = static_cast<int>(100 * fraction);
    if (options_.quiet || percent == percent_ || !(options_.json || terminal_)) {
        return;
    }
    if (options_.json) {
        if (percent / 10 == percent_ / 10 && percent_ >= 0) {
            return;  // ten lines are enough for a log
        }
        line(json_line({{"level", "progress"},
                        {"code", "progress"},
                        {"text", std::to_string(percent) + " %"},
                        {"percent", percent}}));
    } else {
        std::fprintf(stderr, "\r%3d %% ", percent);
    }
    percent_ = percent;
}

void Log::timing(Times times) const {
    if (options_.timing) {
        Json object;
        for (const auto& time : times) {
            std::visit([&](auto number) { object[time.first] = number; }, time.second);
        }
        std::fputs((json_line(object) + "\n").c_str(), stderr);
    }
}

void Log::timing(const Timing& timing, double write_s, std::int64_t windows) const {
    this->timing({{"read_s", timing.read_s},
                  {"carrier_s", timing.carrier_s},
                  {"estimate_s", timing.estimate_s},
                  {"write_s", write_s},
                  {"windows", windows},
                  {"threads", timing.threads}});
}

std::string text_of(const Estimate& estimate, const std::string& unit) {
    if (unit == "rad") {
        return text_of(180 / std::numbers::pi * estimate, "deg");
    }
    if (!estimate.given()) {
        return "- " + english(estimate.reason);
    }
    const QuantityText text = quantity_text(estimate.value, estimate.sd, estimate.u);
    const auto power = [](int exponent) {
        return exponent != 0 ? "e" + std::to_string(exponent) : std::string();
    };
    std::string numbers = text.value;
    if (!text.sd.empty()) {
        numbers += " ± " + text.sd;
    }
    if (text.exponent != 0) {
        numbers = "(" + numbers + ")" + power(text.exponent);
    }
    if (!unit.empty()) {
        numbers += " " + unit;
    }
    return text.u.empty() ? numbers : numbers + ", u " + text.u + power(text.u_exponent);
}

std::string line(const std::string& name, const std::string& text) {
    constexpr std::size_t column = 28;
    const std::string indented = "  " + name;
    return indented + std::string(column - std::min(column - 1, indented.size()), ' ') + text +
           "\n";
}

std::string label_of(std::string name) {
    const auto* const unit = std::ranges::find_if(
        name_units, [&name](const char* each) { return name.ends_with(each); });
    if (unit != name_units.end()) {
        name.resize(name.size() - std::string_view(*unit).size());
    }
    return name;
}

}  // namespace vybeg::cli
