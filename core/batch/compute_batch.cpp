#include "core/batch/compute_batch.h"

#include "core/analysis/setting_table.h"
#include "core/base/number_text.h"
#include "core/base/read_value.h"
#include "core/batch/batch_paths.h"
#include "core/batch/list_sets.h"
#include "core/batch/set_work.h"
#include "core/database/results_database.h"
#include "core/output/batch_csv.h"
#include "core/output/output_file.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/samples/open_table.h"

#include <filesystem>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

namespace fs = std::filesystem;

// The sets that are asked for.
Result<MeasurementList> chosen_list(const BatchRequest& request, const BatchEvents& events) {
    Result<MeasurementList> list = wanted_list(request);
    if (!list) {
        return list;
    }
    if (events.warned) {
        events.warned(list->warnings);
    }
    if (!request.only.empty()) {
        Result<MeasurementSet> set = set_named(*list, "--only", request.only);
        if (!set) {
            return set.error();
        }
        list->sets = {std::move(*set)};
    }
    return list;
}

// Gives each task the key of its row. `database`: its identity, or empty.
Status set_keys(const BatchRequest& request, const std::string& database,
                std::vector<SetTask>& tasks) {
    for (SetTask& task : tasks) {
        Result<std::string> key = row_key(request.program, *task.set, task.passport,
                                          {task.json, database}, request.compare.f_limit_ppm);
        if (!key) {
            return key.error();
        }
        task.key = std::move(*key);
    }
    return {};
}

// Opens the database of the request, if it names one; sets its identity.
Status open_database(const BatchRequest& request, const BatchEvents& events, const JobControl& job,
                     std::optional<ResultsDatabase>& database, std::string& identity) {
    if (request.database.empty()) {
        return {};
    }
    constexpr double patience_s = 60;
    Result<ResultsDatabase> opened = ResultsDatabase::open(
        request.database, ResultsDatabase::Access::write, job, patience_s, events.waiting);
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
    std::vector<std::string> lines{request.program,
                                   (folder ? "folder: " : "list: ") + name.string()};
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

// The rows of an earlier batch.
Status tell_kept_rows(const std::vector<SetTask>& tasks, const RowJournal& journal,
                      const BatchEvents& events) {
    for (std::size_t k = 0; k < tasks.size() && events.finished; ++k) {
        if (journal.has(tasks[k].key)) {
            const Result<std::string> row = journal.row(tasks[k].key);
            if (!row) {
                return row.error();
            }
            events.finished({k, *row, true, {}, {}});
        }
    }
    return {};
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
    if (journal.empty()) {  // rows of other settings may be wanted again
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

Status compute_batch(const BatchRequest& request, const BatchEvents& events, std::stop_token stop) {
    const JobControl job(stop);
    if (Status valid = validate(request.settings); !valid) {
        return valid;
    }
    if (Status valid = check_options(request.open); !valid) {
        return valid;
    }
    const Result<MeasurementList> list = chosen_list(request, events);
    if (!list) {
        return list.error();
    }
    if (!request.passports.empty() && !is_folder(request.passports)) {
        return Error{ErrorCode::file_missing, request.passports, {}};
    }
    Result<std::vector<SetTask>> tasks = tasks_of(request, *list);
    const auto header = header_of(request, job);
    if (!tasks || !header) {
        return tasks ? header.error() : tasks.error();
    }
    Status possible = check_paths(request, *tasks);
    possible = possible && !request.json.empty() ? make_folder(request.json) : possible;
    if (!possible) {
        return possible;
    }
    Result<OutputFile> output = open_output(request.output, job);
    if (!output) {
        return output.error();
    }
    if (request.resume && !output->seekable()) {
        return refused_value("-o", request.output, "--resume needs a file");
    }
    std::optional<ResultsDatabase> database;
    std::string identity;
    possible = open_database(request, events, job, database, identity);
    possible = possible ? set_keys(request, identity, *tasks) : possible;
    if (!possible) {
        return possible;
    }
    Result<RowJournal> journal =
        RowJournal::open(output->seekable() ? journal_of(request.output) : "", request.resume);
    if (!journal) {
        return journal.error();
    }
    if (events.warned && journal->found() > 0) {
        events.warned({{DiagnosticKind::earlier_rows,
                        {journal_of(request.output),
                         count_arg(static_cast<std::int64_t>(journal->found()))}}});
    }
    if (events.begun) {
        events.begun(*list);
    }
    if (Status told = tell_kept_rows(*tasks, *journal, events); !told) {
        return told;
    }
    SetWork work({request, *tasks, list->other_columns, *journal, database ? &*database : nullptr},
                 events, stop);
    Status done = work.run();
    if (done) {
        done = write_table(*output, batch_head(*header, list->other_columns), *tasks, *journal);
    }
    if (!done) {
        return as_left(done.error(), *output, *journal, work.done(), tasks->size());
    }
    journal->remove();
    return {};
}

}  // namespace vybeg
