#include "app/cli_commands.h"
#include "app/cli_identify_text.h"
#include "app/cli_support.h"
#include "core/analysis/setting_table.h"
#include "core/batch/batch_sets.h"
#include "core/batch/identify_set.h"
#include "core/database/results_database.h"
#include "core/output/identify_json.h"
#include "core/output/output_paths.h"
#include "core/output/passport_json.h"
#include "core/recording/samples/open_table.h"

#include <nlohmann/json.hpp>

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
    auto list = TRY(read_measurement_list(request.list, {request.open, request.settings}));
    log.warnings(list.warnings);
    if (!request.set.empty() || list.sets.size() > 1) {
        auto set = TRY(set_named(list, "--set", request.set));
        list.sets = {std::move(set)};
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
    TRY(check_outputs(
        {{"-o", summary ? "-" : request.output,
          summary ? "the summary goes there already" : "the result goes there already"},
         {"--passport", request.new_passport, "the passport goes there already"},
         {"--database", request.database, ""}},
        inputs));
    for (const std::string& output : {request.output, request.new_passport}) {
        if (output != "-") {
            TRY(check_ending(output, {"", ".json"}));
        }
    }
    return {};
}

Result<std::optional<ResultsDatabase>> open_database(const std::string& name, const JobControl& job,
                                                     Log& log) {
    if (name.empty()) {
        return std::optional<ResultsDatabase>();
    }
    constexpr double patience_s = 60;
    auto database = TRY(ResultsDatabase::open(
        name, ResultsDatabase::Access::write, job, patience_s,
        [&log](const Diagnostic& waiting) { log.warnings(std::vector{waiting}); }));
    return std::optional(std::move(database));
}

// Before the files, as batch does: the same again replaces what a failure of them leaves. Warns of
// another name that the database has for this result.
Status store(ResultsDatabase& database, const StoredResult& result, Log& log) {
    const auto holder = TRY(database.holder(result.key));
    const StoredName own{result.set, result.gyro};
    if (holder && *holder != own) {
        log.warnings(std::vector{same_recordings(own, *holder)});
    }
    TRY(database.add(result));
    return {};
}

void tell_timing(const Identification& identification, double open_s, double write_s) {
    const IdentifyTiming& timing = identification.timing;
    std::int64_t windows = 0;
    for (const IdentifiedRun& run : identification.runs) {
        windows += run.windows;
    }
    say_timing({{"open_s", open_s},
                {"read_s", timing.read_s},
                {"carrier_s", timing.carrier_s},
                {"estimate_s", timing.estimate_s},
                {"windows_s", timing.windows_s},
                {"fit_s", timing.fit_s},
                {"write_s", write_s},
                {"windows", windows},
                {"threads", timing.threads}});
}

}  // namespace

Status run_identify(const IdentifyRequest& request, Log& log, std::stop_token stop) {
    TRY(validate(request.settings));
    TRY(check_options(request.open));
    const auto list = TRY(wanted_set(request, log));
    const MeasurementSet& set = list.sets.front();
    const double begun = seconds_now();
    const auto open = TRY(open_set(set, request.old_passport, stop));
    TRY(check_paths(request, set));
    // Before the work is done: a missing folder shows at once.
    const bool summary = request.output.empty();
    auto output = TRY(open_output(summary ? "-" : request.output, silent_job(stop)));
    auto passport = TRY(open_named(request.new_passport, silent_job(stop)));
    auto database = TRY(open_database(request.database, silent_job(stop), log));
    const double opened = seconds_now();
    const Result<SetResult> result =
        identify_set(open, program, request.compare, job_of(stop, log));
    if (!result) {
        log.warnings(warnings_of(open));
        return result.error();
    }
    log.warnings(warnings_of(open, *result));
    const double identified = seconds_now();
    if (database) {
        const auto to_store = TRY(stored_result(*result, identify_json(*result)));
        TRY(store(*database, to_store, log));
    }
    // All of them appear, or none: a text that has no room in memory is missed before the first.
    const std::string text = summary ? identify_text(*result) : identify_json(*result);
    const std::string kept = passport ? passport_json(passport_of(*result)) : std::string();
    std::vector<OutputFile*> files{&output};
    TRY(output.write(text));
    if (passport) {
        TRY(passport->write(kept));
        files.push_back(&*passport);
    }
    TRY(OutputFile::commit_together(files));
    if (request.timing) {
        tell_timing(result->identification, opened - begun, seconds_now() - identified);
    }
    return {};
}

}  // namespace vybeg::cli
