#include "app/analysis_options.h"
#include "app/cli_commands.h"
#include "app/cli_identify_text.h"
#include "app/cli_support.h"
#include "app/output_paths.h"
#include "core/analysis/setting_table.h"
#include "core/output/identify_json.h"
#include "core/output/passport_json.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/file_changes.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <list>
#include <optional>
#include <utility>

namespace vybeg::cli {
namespace {

struct Inputs {
    std::vector<Recording> recordings;
    std::vector<IdentifiedInput> told;
    std::vector<std::string> hashes;
};

Result<Inputs> open_inputs(const IdentifyRequest& request, std::stop_token stop) {
    Inputs inputs;
    for (const std::string& name : request.inputs) {
        Result<Recording> recording = open_recording(name, request.open, silent_job(stop));
        if (!recording) {
            return recording.error();
        }
        inputs.recordings.push_back(std::move(*recording));
    }
    // All hashes beside each other.
    std::list<HashBeside> hashes;
    for (const Recording& recording : inputs.recordings) {
        hashes.emplace_back(recording, request.settings.threads, stop);
    }
    for (const Recording& recording : inputs.recordings) {
        Result<std::string> sha256 = hashes.front().get();
        if (!sha256) {
            return sha256.error();
        }
        hashes.pop_front();
        inputs.told.push_back({recording.path.filename().string(), *sha256, recording.start,
                               recording.seconds(), recording.rate_hz, 0});
        inputs.hashes.push_back(std::move(*sha256));
    }
    return inputs;
}

Status check_paths(const IdentifyRequest& request) {
    std::vector<InputPath> inputs{{request.old_passport, "it is the passport to compare with"}};
    for (const std::string& input : request.inputs) {
        inputs.push_back({input, "it is one of the recordings"});
    }
    const bool summary = request.output.empty();
    return check_outputs(
        {{"-o", summary ? "-" : request.output,
          summary ? "the summary goes there already" : "the result goes there already"},
         {"--passport", request.new_passport, ""}},
        inputs);
}

// What was asked for, opened before the work is done: a missing folder shows at once.
struct Outputs {
    std::optional<OutputFile> result;
    std::optional<OutputFile> passport;
};

Status open_into(const std::string& name, std::optional<OutputFile>& output,
                 const JobControl& job) {
    if (name.empty()) {
        return {};
    }
    Result<OutputFile> file = open_output(name, job);
    if (!file) {
        return file.error();
    }
    output.emplace(std::move(*file));
    return {};
}

// All of them appear, or none.
Status write_outputs(Outputs& outputs, const std::string& result, const std::string& passport) {
    std::vector<OutputFile*> files;
    for (const auto& [output, text] :
         {std::pair{&outputs.result, &result}, std::pair{&outputs.passport, &passport}}) {
        if (*output) {
            if (const Status written = (*output)->write(*text); !written) {
                return written;
            }
            files.push_back(&**output);
        }
    }
    return OutputFile::commit_together(files);
}

std::string timing_line(const Identification& identification, double open_s, double write_s) {
    const IdentifyTiming& timing = identification.timing;
    std::int64_t windows = 0;
    for (const IdentifiedRun& run : identification.runs) {
        windows += run.windows;
    }
    const nlohmann::ordered_json line{{"open_s", open_s},
                                      {"read_s", timing.read_s},
                                      {"carrier_s", timing.carrier_s},
                                      {"estimate_s", timing.estimate_s},
                                      {"windows_s", timing.windows_s},
                                      {"fit_s", timing.fit_s},
                                      {"write_s", write_s},
                                      {"windows", windows},
                                      {"threads", timing.threads}};
    return line.dump() + "\n";
}

Result<std::optional<PassportComparison>> old_passport(const IdentifyRequest& request,
                                                       std::optional<Passport>& passport,
                                                       const JobControl& job) {
    if (request.old_passport.empty()) {
        return std::optional<PassportComparison>();
    }
    Result<Passport> read = read_passport_file(request.old_passport);
    if (!read) {
        return read.error();
    }
    const Result<std::string> sha256 = file_sha256(request.old_passport, job);
    if (!sha256) {
        return sha256.error();
    }
    passport = std::move(*read);
    return std::optional(PassportComparison{request.old_passport, *sha256, passport->program, {}});
}

void warn_of(const std::vector<Recording>& recordings, Log& log) {
    for (const Recording& recording : recordings) {
        log.warnings(recording.diagnostics, recording.path.filename().string());
    }
}

Status all_unchanged(const std::vector<Recording>& recordings) {
    for (const Recording& recording : recordings) {
        if (Status still = unchanged(recording); !still) {
            return still;
        }
    }
    return {};
}

}  // namespace

int run_identify(const IdentifyRequest& request, Log& log, std::stop_token stop) {
    if (const Status valid = validate(request.settings); !valid) {
        return log.fail(valid.error());
    }
    const double begun = seconds_now();
    std::optional<Passport> passport;
    auto comparison = old_passport(request, passport, silent_job(stop));
    if (!comparison) {
        return log.fail(comparison.error());
    }
    Result<Inputs> inputs = open_inputs(request, stop);
    if (!inputs) {
        return log.fail(inputs.error());
    }
    if (const Status distinct = check_distinct(inputs->recordings, inputs->hashes); !distinct) {
        return log.fail(distinct.error());
    }
    if (const Status possible = check_paths(request); !possible) {
        return log.fail(possible.error());
    }
    Outputs outputs;
    const bool summary = request.output.empty();
    for (const auto& [name, output] :
         {std::pair{summary ? std::string("-") : request.output, &outputs.result},
          std::pair{request.new_passport, &outputs.passport}}) {
        if (const Status opened = open_into(name, *output, silent_job(stop)); !opened) {
            return log.fail(opened.error());
        }
    }
    const double opened = seconds_now();
    const Result<Identification> found =
        identify(inputs->recordings, request.settings, job_of(stop, log));
    const Status still = all_unchanged(inputs->recordings);
    if (!found || !still) {
        warn_of(inputs->recordings, log);
        return log.fail(still ? found.error() : still.error());
    }
    log.warnings(without_effect(request.settings));
    for (const Recording& recording : inputs->recordings) {
        log.warnings(without_effect(request.open, recording), recording.path.filename().string());
    }
    for (std::size_t k = 0; k < found->runs.size(); ++k) {
        inputs->told[k].f0_hz = found->runs[k].f0_hz;
        log.warnings(found->runs[k].diagnostics, inputs->told[k].name);
    }
    log.warnings(found->fit.warnings);
    const double identified = seconds_now();
    PassportComparison* const compared = *comparison ? &**comparison : nullptr;
    if (compared != nullptr) {
        compared->differences = compare(*passport, found->fit, request.compare);
    }
    const Status written = write_outputs(
        outputs,
        summary ? identify_text(inputs->told, *found, compared)
                : identify_json(program, inputs->told, *found, compared),
        outputs.passport ? passport_json(passport_of(program, inputs->told, *found)) : "");
    if (!written) {
        return log.fail(written.error());
    }
    if (request.timing) {
        std::fputs(timing_line(*found, opened - begun, seconds_now() - identified).c_str(), stderr);
    }
    return 0;
}

}  // namespace vybeg::cli
