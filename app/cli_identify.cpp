#include "app/cli_commands.h"
#include "app/cli_identify_text.h"
#include "app/cli_support.h"
#include "core/analysis/setting_table.h"
#include "core/batch/identify_set.h"
#include "core/batch/list_sets.h"
#include "core/database/results_database.h"
#include "core/output/identify_json.h"
#include "core/output/output_paths.h"
#include "core/output/passport_json.h"
#include "core/recording/samples/open_table.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <optional>
#include <utility>

namespace vybeg::cli {
namespace {

// The recordings of the command line as one set, or that of the list.
Result<MeasurementList> wanted_set(const IdentifyRequest& request, Log& log) {
    if (request.list.empty()) {
        MeasurementSet set{request.inputs.front(), {}, request.settings};
        for (const std::string& name : request.inputs) {
            set.recordings.push_back({name, name, request.open});
        }
        return MeasurementList{{}, {std::move(set)}, {}};
    }
    Result<MeasurementList> list =
        read_measurement_list(request.list, {request.open, request.settings});
    if (!list) {
        return list.error();
    }
    log.warnings(list->warnings);
    if (!request.set.empty() || list->sets.size() > 1) {
        auto set = TRY(set_named(*list, "--set", request.set));
        list->sets = {std::move(set)};
    }
    return list;
}

Status check_paths(const IdentifyRequest& request, const MeasurementSet& set) {
    std::vector<InputPath> inputs{{request.old_passport, "it is the passport to compare with"},
                                  {request.list, "it is the list of the recordings"}};
    for (const RecordingRef& recording : set.recordings) {
        inputs.push_back({recording.path.string(), "it is one of the recordings"});
    }
    if (request.database == "-") {
        return refused_value("--database", request.database, "it must be a file");
    }
    const bool summary = request.output.empty();
    Status possible = check_outputs(
        {{"-o", summary ? "-" : request.output,
          summary ? "the summary goes there already" : "the result goes there already"},
         {"--passport", request.new_passport, "the passport goes there already"},
         {"--database", request.database, ""}},
        inputs);
    for (const std::string& output : {request.output, request.new_passport}) {
        if (const Status known = check_ending(output, {"", ".json"});
            possible && output != "-" && !known) {
            possible = known;
        }
    }
    return possible;
}

// What was asked for, opened before the work is done: a missing folder shows at once.
struct Outputs {
    std::optional<OutputFile> result;
    std::optional<OutputFile> passport;
    std::optional<ResultsDatabase> database;
};

Status open_into(const std::string& name, std::optional<OutputFile>& output,
                 const JobControl& job) {
    if (name.empty()) {
        return {};
    }
    auto file = TRY(open_output(name, job));
    output.emplace(std::move(file));
    return {};
}

Status open_into(const std::string& name, std::optional<ResultsDatabase>& database,
                 const JobControl& job, Log& log) {
    if (name.empty()) {
        return {};
    }
    constexpr double patience_s = 60;
    Result<ResultsDatabase> opened = ResultsDatabase::open(
        name, ResultsDatabase::Access::write, job, patience_s,
        [&log](const Diagnostic& waiting) { log.warnings(std::vector{waiting}); });
    if (!opened) {
        return opened.error();
    }
    database.emplace(std::move(*opened));
    return {};
}

// Before the files, as batch does: the same again replaces what a failure of them leaves. Warns of
// another name that the database has for this result.
Status store(ResultsDatabase& database, const StoredResult& result, Log& log) {
    const auto holder = TRY(database.holder(result.key));
    const StoredName own{result.set, result.gyro};
    if (holder && *holder != own) {
        log.warnings(std::vector{same_recordings(own, *holder)});
    }
    const Result<std::int64_t> added = database.add(result);
    return added ? Status() : added.error();
}

// All of them appear, or none.
Status write_outputs(Outputs& outputs, const std::string& result, const std::string& passport) {
    std::vector<OutputFile*> files;
    for (const auto& [output, text] :
         {std::pair{&outputs.result, &result}, std::pair{&outputs.passport, &passport}}) {
        if (*output) {
            TRY((*output)->write(*text));
            files.push_back(&**output);
        }
    }
    return OutputFile::commit_together(files);
}

std::string identify_timing_line(const Identification& identification, double open_s,
                                 double write_s) {
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

}  // namespace

int run_identify(const IdentifyRequest& request, Log& log, std::stop_token stop) {
    if (const Status valid = validate(request.settings); !valid) {
        return log.fail(valid.error());
    }
    if (const Status valid = check_options(request.open); !valid) {
        return log.fail(valid.error());
    }
    const Result<MeasurementList> list = wanted_set(request, log);
    if (!list) {
        return log.fail(list.error());
    }
    const MeasurementSet* const set = &list->sets.front();
    const double begun = seconds_now();
    Result<OpenSet> open = open_set(*set, request.old_passport, stop);
    if (!open) {
        return log.fail(open.error());
    }
    if (const Status possible = check_paths(request, *set); !possible) {
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
    if (const Status there = open_into(request.database, outputs.database, silent_job(stop), log);
        !there) {
        return log.fail(there.error());
    }
    const double opened = seconds_now();
    const Result<SetResult> result =
        identify_set(*open, program, request.compare, job_of(stop, log));
    if (!result) {
        log.warnings(warnings_of(*open));
        return log.fail(result.error());
    }
    log.warnings(warnings_of(*open, *result));
    const double identified = seconds_now();
    if (outputs.database) {
        const auto to_store = stored_result(*result, identify_json(*result));
        const Status stored =
            to_store ? store(*outputs.database, *to_store, log) : Status(to_store.error());
        if (!stored) {
            return log.fail(stored.error());
        }
    }
    const Status written =
        write_outputs(outputs, summary ? identify_text(*result) : identify_json(*result),
                      outputs.passport ? passport_json(passport_of(*result)) : "");
    if (!written) {
        return log.fail(written.error());
    }
    if (request.timing) {
        std::fputs(
            identify_timing_line(result->identification, opened - begun, seconds_now() - identified)
                .c_str(),
            stderr);
    }
    return 0;
}

}  // namespace vybeg::cli
