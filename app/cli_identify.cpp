#include "app/cli_commands.h"
#include "app/cli_identify_text.h"
#include "app/cli_support.h"
#include "core/report/identify_json.h"
#include "core/report/passport_json.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <optional>
#include <utility>

namespace vybeg::cli {
namespace {

struct Inputs {
    std::vector<Recording> recordings;
    std::vector<IdentifiedInput> told;
};

Result<Inputs> open_inputs(const IdentifyRequest& request, const JobControl& job) {
    Inputs inputs;
    for (const std::string& name : request.inputs) {
        Result<Recording> recording = open_recording(name, request.open, job);
        if (!recording) {
            return recording.error();
        }
        const Result<std::string> sha256 = file_sha256(name, job);
        if (!sha256) {
            return sha256.error();
        }
        inputs.told.push_back({recording->path.filename().string(), *sha256, recording->start,
                               recording->seconds(), recording->rate_hz, 0});
        inputs.recordings.push_back(std::move(*recording));
    }
    return inputs;
}

// An output must replace neither an input nor the other output.
Status check_outputs(const IdentifyRequest& request) {
    const auto refused = [](const char* option, const std::string& value, const char* reason) {
        return Error{ErrorCode::setting_invalid, "", {option, value, reason}};
    };
    for (const auto& [option, output] :
         {std::pair{"-o", &request.output}, std::pair{"--passport", &request.new_passport}}) {
        if (output->empty()) {
            continue;
        }
        for (const std::string& input : request.inputs) {
            if (same_file(input, *output)) {
                return refused(option, *output, "it is one of the recordings");
            }
        }
        if (same_file(request.old_passport, *output)) {
            return refused(option, *output, "it is the passport to compare with");
        }
    }
    if (!request.new_passport.empty() && (request.new_passport == request.output ||
                                          same_file(request.output, request.new_passport))) {
        return refused("--passport", request.new_passport, "the result goes there already");
    }
    return {};
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

// Both files are whole on the disk before the first takes its place.
Status write_outputs(Outputs& outputs, const std::string& result, const std::string& passport) {
    Status status;
    for (const auto& [output, text] :
         {std::pair{&outputs.result, &result}, std::pair{&outputs.passport, &passport}}) {
        if (status && *output) {
            status = (*output)->write(*text);
        }
        if (status && *output) {
            status = (*output)->flush();
        }
    }
    for (std::optional<OutputFile>* output : {&outputs.result, &outputs.passport}) {
        if (status && *output) {
            status = (*output)->commit();
        }
    }
    return status;
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

}  // namespace

int run_identify(const IdentifyRequest& request, Log& log, std::stop_token stop) {
    if (const Status valid = validate(request.settings.signal); !valid) {
        return log.fail(valid.error());
    }
    const double begun = seconds_now();
    std::optional<Passport> passport;
    auto comparison = old_passport(request, passport, silent_job(stop));
    if (!comparison) {
        return log.fail(comparison.error());
    }
    Result<Inputs> inputs = open_inputs(request, silent_job(stop));
    if (!inputs) {
        return log.fail(inputs.error());
    }
    if (const Status possible = check_outputs(request); !possible) {
        return log.fail(possible.error());
    }
    Outputs outputs;
    for (const auto& [name, output] : {std::pair{&request.output, &outputs.result},
                                       std::pair{&request.new_passport, &outputs.passport}}) {
        if (const Status opened = open_into(*name, *output, silent_job(stop)); !opened) {
            return log.fail(opened.error());
        }
    }
    const double opened = seconds_now();
    const Result<Identification> found =
        identify(inputs->recordings, request.settings, job_of(stop, log));
    if (!found) {
        warn_of(inputs->recordings, log);
        return log.fail(found.error());
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
    Status written = write_outputs(
        outputs, identify_json(program, inputs->told, *found, compared),
        outputs.passport ? passport_json(passport_of(program, inputs->told, *found)) : "");
    if (written && request.output.empty()) {
        written = write_text(identify_text(inputs->told, *found, compared), silent_job(stop));
    }
    if (!written) {
        return log.fail(written.error());
    }
    if (request.timing) {
        std::fputs(timing_line(*found, opened - begun, seconds_now() - identified).c_str(), stderr);
    }
    return 0;
}

}  // namespace vybeg::cli
