#include "app/cli_commands.h"
#include "app/cli_support.h"
#include "app/list_sets.h"
#include "app/output_paths.h"
#include "app/set_work.h"
#include "core/analysis/setting_table.h"
#include "core/base/number_text.h"
#include "core/base/read_value.h"
#include "core/base/system_reason.h"
#include "core/database/results_database.h"
#include "core/output/batch_csv.h"
#include "core/output/same_file.h"
#include "core/recording/bytes/sha256.h"

#include <climits>
#include <filesystem>
#include <optional>
#include <set>
#include <sys/stat.h>
#include <system_error>
#include <utility>

namespace vybeg::cli {
namespace {

namespace fs = std::filesystem;

// Finished rows of a table that is not complete, beside it.
std::string journal_of(const std::string& output) {
    return output + ".unfinished";
}

// The journal of SQLite beside a database.
std::string rollback_of(const std::string& database) {
    return database + "-journal";
}

bool is_folder(const std::string& path) {
    std::error_code unknown;
    return fs::is_directory(path, unknown);
}

Result<MeasurementList> wanted_list(const BatchRequest& request) {
    const ListDefaults defaults{request.open, request.settings};
    if (!is_folder(request.list)) {
        return read_measurement_list(request.list, defaults);
    }
    return list_of_folder(request.list, defaults, [&request](const fs::path& path) {
        return same_file(path, request.output) || same_file(path, journal_of(request.output)) ||
               (!request.database.empty() && (same_file(path, request.database) ||
                                              same_file(path, rollback_of(request.database))));
    });
}

// A folder for results, made where there is none.
Status make_folder(const std::string& path) {
    std::error_code failed;
    fs::create_directories(path, failed);
    return failed ? Status(Error{ErrorCode::output_failed, path, {system_reason(failed.value())}})
                  : Status();
}

Status check_paths(const BatchRequest& request, const std::vector<SetTask>& tasks) {
    std::vector<InputPath> inputs{{request.list, "it is the list of the recordings"}};
    for (const SetTask& task : tasks) {
        inputs.push_back({task.passport, "it is one of the passports"});
        for (const ListedRecording& recording : task.set->recordings) {
            inputs.push_back({recording.path.string(), "it is one of the recordings"});
        }
    }
    if (request.database == "-") {
        return refused_value("--database", request.database, "it must be a file");
    }
    const char* const by_table = "the table goes there already";
    if (Status possible = check_outputs(
            {{"-o", request.output, by_table}, {"--database", request.database, ""}}, inputs);
        !possible) {
        return possible;
    }
    if (!request.database.empty()) {
        if (same_file(request.database, journal_of(request.output)) ||
            same_file(rollback_of(request.database), request.output)) {
            return refused_value("--database", request.database, by_table);
        }
        inputs.push_back({request.database, ""});
    }
    // Many results and many inputs: by device and inode instead of pair by pair.
    std::set<std::pair<dev_t, ino_t>> taken;
    inputs.push_back({request.output, ""});
    for (const InputPath& input : inputs) {
        struct stat status {};
        if (stat(input.path.c_str(), &status) == 0) {
            taken.emplace(status.st_dev, status.st_ino);
        }
    }
    for (const SetTask& task : tasks) {
        struct stat status {};
        const bool is_taken = !task.json.empty() && stat(task.json.c_str(), &status) == 0 &&
                              taken.contains({status.st_dev, status.st_ino});
        // The table and the folder of the results may both be still to come.
        const bool is_output =
            !task.json.empty() &&
            (same_file(task.json, request.output) ||
             (!request.database.empty() && same_file(task.json, request.database)));
        if (is_taken || is_output) {
            return refused_value("--json", task.json, "it is an input, the table or the database");
        }
    }
    return {};
}

Result<std::vector<SetTask>> tasks_of(const BatchRequest& request, const MeasurementList& list) {
    std::vector<SetTask> tasks;
    for (const MeasurementSet& set : list.sets) {
        SetTask task{&set, passport_in(request.passports, set), "", ""};
        if (!request.json.empty()) {
            const fs::path file = json_in(request.json, set.name);
            if (file.filename().string().size() > NAME_MAX) {
                return refused_value("--json", set.name, "this name is too long for a file");
            }
            task.json = file.string();
        }
        tasks.push_back(std::move(task));
    }
    return tasks;
}

// Gives each task the key of its row. `database`: its identity, or empty.
Status set_keys(const BatchRequest& request, const std::string& database,
                std::vector<SetTask>& tasks) {
    for (SetTask& task : tasks) {
        Result<std::string> key =
            row_key(*task.set, task.passport, {task.json, database}, request.compare.f_limit_ppm);
        if (!key) {
            return key.error();
        }
        task.key = std::move(*key);
    }
    return {};
}

// The database that is asked for; `identity` is told who it is.
Status open_database(const BatchRequest& request, const JobControl& job,
                     std::optional<ResultsDatabase>& database, std::string& identity) {
    if (request.database.empty()) {
        return {};
    }
    Result<ResultsDatabase> opened =
        ResultsDatabase::open(request.database, ResultsDatabase::Access::write, job);
    if (!opened) {
        return opened.error();
    }
    Result<std::string> own = opened->identity();
    if (!own) {
        return own.error();
    }
    identity = std::move(*own);
    database.emplace(std::move(*opened));
    return {};
}

Result<std::vector<std::string>> header_of(const BatchRequest& request, const JobControl& job) {
    const bool folder = is_folder(request.list);
    const fs::path path = fs::path(request.list).lexically_normal();
    const fs::path name = path.has_filename() ? path.filename() : path.parent_path().filename();
    std::vector<std::string> lines{program, (folder ? "folder: " : "list: ") + name.string()};
    if (!folder) {
        const Result<std::string> sha256 = file_sha256(request.list, job);
        if (!sha256) {
            return sha256.error();
        }
        lines.push_back("sha256: " + *sha256);
    }
    if (request.open.rate_hz) {
        lines.push_back("rate: " + round_trip_text(*request.open.rate_hz));
    }
    lines.push_back("channels: " + integer_text(request.open.channel_c) + "," +
                    integer_text(request.open.channel_d));
    if (const std::string read_with = options_text(request.open); !read_with.empty()) {
        lines.push_back("read with: " + read_with);
    }
    for (const auto& [setting, value] : settings_list(request.settings)) {
        lines.push_back(setting + ": " + value);
    }
    if (!request.passports.empty()) {
        lines.push_back("f-limit: " + round_trip_text(request.compare.f_limit_ppm));
    }
    return lines;
}

Status write_table(OutputFile& output, const std::string& head, const std::vector<SetTask>& tasks,
                   const RowJournal& journal) {
    Status written = output.write(head + "\n");
    for (const SetTask& task : tasks) {
        if (!written) {
            return written;
        }
        const Result<std::string> row = journal.row(task.key);
        written = row ? output.write(*row + "\n") : Status(row.error());
    }
    return written ? output.commit() : written;
}

// The error that ends a batch; one of an interruption that leaves rows names --resume. Removes a
// journal without rows.
Error as_left(const Error& error, const OutputFile& output, RowJournal& journal, std::size_t done,
              std::size_t sets) {
    if (done == 0) {
        journal.remove();
    }
    const bool kept = done > 0 && output.seekable();
    return error.code == ErrorCode::interrupted && kept
               ? Error{ErrorCode::interrupted_midway,
                       output.name(),
                       {count_arg(static_cast<std::int64_t>(done)),
                        count_arg(static_cast<std::int64_t>(sets))}}
               : output.as_it_stands(error);
}

}  // namespace

int run_batch(const BatchRequest& request, Log& log, std::stop_token stop) {
    if (const Status valid = validate(request.settings); !valid) {
        return log.fail(valid.error());
    }
    if (const Status valid = check_options(request.open); !valid) {
        return log.fail(valid.error());
    }
    Result<MeasurementList> list = wanted_list(request);
    if (!list) {
        return log.fail(list.error());
    }
    log.warnings(list->warnings);
    if (!request.only.empty()) {
        Result<MeasurementSet> set = set_named(*list, "--only", request.only);
        if (!set) {
            return log.fail(set.error());
        }
        list->sets = {std::move(*set)};
    }
    if (!request.passports.empty() && !is_folder(request.passports)) {
        return log.fail({ErrorCode::file_missing, request.passports, {}});
    }
    Result<std::vector<SetTask>> tasks = tasks_of(request, *list);
    const auto header = header_of(request, silent_job(stop));
    if (!tasks || !header) {
        return log.fail(tasks ? header.error() : tasks.error());
    }
    Status possible = check_paths(request, *tasks);
    possible = possible && !request.json.empty() ? make_folder(request.json) : possible;
    if (!possible) {
        return log.fail(possible.error());
    }
    Result<OutputFile> output = open_output(request.output, silent_job(stop));
    if (!output) {
        return log.fail(output.error());
    }
    if (request.resume && !output->seekable()) {
        return log.fail(refused_value("-o", request.output, "--resume needs a file"));
    }
    std::optional<ResultsDatabase> database;
    std::string identity;
    possible = open_database(request, silent_job(stop), database, identity);
    possible = possible ? set_keys(request, identity, *tasks) : possible;
    if (!possible) {
        return log.fail(possible.error());
    }
    Result<RowJournal> journal =
        RowJournal::open(output->seekable() ? journal_of(request.output) : "", request.resume);
    if (!journal) {
        return log.fail(journal.error());
    }
    SetWork work(request, *tasks, list->other_columns, *journal, database ? &*database : nullptr,
                 log, stop);
    Status done = work.run();
    if (done) {
        done = write_table(*output, batch_head(*header, list->other_columns), *tasks, *journal);
    }
    if (!done) {
        return log.fail(as_left(done.error(), *output, *journal, work.done(), tasks->size()));
    }
    journal->remove();
    return 0;
}

}  // namespace vybeg::cli
