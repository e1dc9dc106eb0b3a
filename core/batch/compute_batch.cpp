#include "core/analysis/measurement_list.h"
#include "core/analysis/setting_table.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/base/read_value.h"
#include "core/base/result.h"
#include "core/batch/batch_request.h"
#include "core/batch/batch_sets.h"
#include "core/batch/identify_set.h"
#include "core/database/results_database.h"
#include "core/output/batch_csv.h"
#include "core/output/output_file.h"
#include "core/output/passport_json.h"
#include "core/output/row_journal.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/text/csv_rows.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

namespace fs = std::filesystem;

Result<std::vector<std::string>> header_of(const BatchRequest& request, const JobControl& job) {
    const bool folder = is_folder(request.list);
    const fs::path path = fs::path(request.list).lexically_normal();
    const fs::path name = path.has_filename() ? path.filename() : path.parent_path().filename();
    std::vector<std::string> lines{request.program,
                                   (folder ? "folder: " : "list: ") + name.string()};
    if (!folder) {
        const auto sha256 = TRY(file_sha256(request.list, job));
        lines.push_back("sha256: " + sha256);
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
    if (!request.compare.limits.empty()) {
        lines.push_back("limit: " + practical_limits_text(request.compare.limits));
    }
    if (!request.limits.empty()) {
        const auto sha256 = TRY(file_sha256(request.limits, job));
        lines.push_back("limits: " + fs::path(request.limits).filename().string() +
                        ", sha256: " + sha256);
    }
    return lines;
}

// How many sets do not keep the limits, by the table's column.
struct LimitCounts {
    std::int64_t failed = 0;
    std::int64_t undecided = 0;
};

Status write_table(OutputFile& output, const BatchRequest& request, const MeasurementList& list,
                   const std::vector<std::string>& header, const std::vector<SetTask>& tasks,
                   const RowJournal& journal, const std::string& request_key, LimitCounts& counts) {
    const bool limits = !request.limits.empty();
    const std::string head = batch_head(header, list.other_columns, limits);
    std::vector<std::string> rows;
    if (request.watch) {
        rows = rows_of_left_sets(tasks, journal, request_key, limits,
                                 batch_columns(limits).size() + list.other_columns.size());
    }
    for (const SetTask& task : tasks) {
        rows.push_back(journal.row(task.key));
    }
    TRY(output.write((request.excel ? excel_head(head) : head) + "\n"));
    for (const std::string& row : rows) {
        const BatchRow fields = csv_fields(row);
        if (limits) {
            const std::string& field = field_of(fields, passed_column);
            counts.failed += field == passed_text(Conformity::outside) ? 1 : 0;
            counts.undecided += field == passed_text(Conformity::unknown) ? 1 : 0;
        }
        TRY(output.write((request.excel ? excel_row(fields, limits) : row) + "\n"));
    }
    return output.commit();
}

// None where the table has no limits.
std::optional<LimitVerdict> verdict_of(const SetTask& task, const Identification* found) {
    return task.limits ? std::optional(limit_verdict(found, *task.limits)) : std::nullopt;
}

// Waits, or until the token stops it.
void pause(const std::stop_token& stop, double seconds) {
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    never.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
}

// A batch, of one list or of all that come to a folder.
class Batch {
public:
    Batch(const BatchRequest& request, const BatchEvents& events, std::stop_token stop)
        : request_(request), events_(events), stop_(std::move(stop)), job_(stop_) {}

    Status compute() {
        TRY(check_request());
        if (request_.watch) {
            return watch();
        }
        const auto list = TRY(chosen_list());
        return compute(list);
    }

private:
    // The sets that are asked for.
    Result<MeasurementList> chosen_list() const {
        auto list = TRY(wanted_list(request_));
        events_.warned(list.warnings);
        if (list.sets.empty()) {
            return Error{ErrorCode::folder_empty, request_.list, {}};
        }
        if (!request_.only.empty()) {
            TRY(keep_set(list, "--only", request_.only));
        }
        return list;
    }

    Status check_request() {
        TRY(validate(request_.settings));
        TRY(check_options(request_.open));
        for (const std::string& folder :
             {request_.passports, request_.watch ? request_.list : std::string()}) {
            if (!folder.empty() && !is_folder(folder)) {
                return Error{ErrorCode::file_missing, folder, {}};
            }
        }
        if (request_.watch && request_.output == "-") {
            return refused_value("-o", request_.output, "--watch needs a file");
        }
        for (const auto& [option, folder] :
             {std::pair{"--json", &request_.json}, {"--passports-out", &request_.new_passports}}) {
            if (request_.watch && same_file(request_.list, *folder)) {
                return refused_value(option, *folder, "recordings come to this folder");
            }
        }
        if (!request_.limits.empty()) {
            limits_ = TRY(read_limits(request_.limits));
        }
        return {};
    }

    // Computes what has come whenever something has, until it is interrupted.
    Status watch() {
        FolderWatch folder(request_);
        std::optional<Error> told;
        std::vector<Diagnostic> warned;
        std::int64_t sets = 0;
        const auto tell = [&](const std::optional<Error>& fault) {
            if (fault != std::exchange(told, fault) && fault && events_.failed) {
                events_.failed(*fault);
            }
        };
        for (bool seen = false; !stop_.stop_requested(); seen = true) {
            const Result<MeasurementList> looked = folder.look();
            if (!looked && seen) {  // a folder of the network may be away for a while
                tell(looked.error());
                pause(stop_, FolderWatch::pause_s);
                continue;
            }
            const auto list = TRY(looked);
            TRY(check_outputs(
                {{"-o", request_.output, ""}, {"--database", request_.database, ""}},
                {{folder.list().string(), Phrase::tr("it is the list of the recordings")}}));
            std::vector<Diagnostic> fresh;
            std::ranges::copy_if(list.warnings, std::back_inserter(fresh), [&](const auto& each) {
                return std::ranges::find(warned, each) == warned.end();
            });
            if (!fresh.empty()) {
                events_.warned(fresh);
                std::ranges::copy(fresh, std::back_inserter(warned));
            }
            tell(folder.fault());
            sets = list.sets.empty() ? sets : std::ssize(list.sets);
            TRY(list.sets.empty() ? Status() : compute(list));
            pause(stop_, FolderWatch::pause_s);
        }
        return sets == 0 ? Error{ErrorCode::interrupted, {}, {}}
                         : Error{ErrorCode::interrupted_midway,
                                 request_.output,
                                 {count_arg(sets), count_arg(sets)}};
    }

    // The table of these sets. Of a folder that is watched it stays as it is where all rows are in.
    Status compute(const MeasurementList& list) {
        auto tasks = TRY(tasks_of(request_, list, limits_));
        const auto header = TRY(header_of(request_, job_));
        if (request_.watch) {
            const std::string columns = joined(batch_columns(!request_.limits.empty()), ",");
            const auto hash = TRY(text_sha256(joined(header, "\n") + columns));
            request_key_ = hash.substr(0, 16) + "-";
        }
        TRY(check_paths(request_, tasks));
        for (const std::string* folder : {&request_.json, &request_.new_passports}) {
            std::error_code failed;
            if (!folder->empty()) {
                fs::create_directories(*folder, failed);
            }
            if (failed) {
                return Error{ErrorCode::output_failed, *folder, {system_reason(failed.value())}};
            }
        }
        if (journal_) {
            TRY(find_rows(tasks));
            if (std::ranges::equal(tasks, written_, {}, &SetTask::key) &&
                std::ranges::all_of(tasks, [this](const auto& task) { return is_kept(task); })) {
                return {};
            }
        }
        auto output = TRY(open_output(request_.output, job_));
        if (!journal_) {
            TRY(open_files(output));
            TRY(find_rows(tasks));
            tell_other_rows(tasks);
        }
        events_.begun(list);
        for (std::size_t k = 0; k < tasks.size(); ++k) {
            if (is_kept(tasks[k])) {  // the row of an earlier batch
                const std::string& row = journal_->row(tasks[k].key);
                events_.finished({.set = k, .fields = csv_fields(row), .kept = true});
            }
        }
        TRY(compute_rows(list, tasks, header, output));
        written_.clear();
        std::ranges::transform(tasks, std::back_inserter(written_), &SetTask::key);
        return {};
    }

    bool is_kept(const SetTask& task) const { return kept_.contains(task.key); }

    // Gives each task the key of its row, and finds the rows that need not be computed.
    Status find_rows(std::vector<SetTask>& tasks) {
        for (SetTask& task : tasks) {
            const auto key = TRY(row_key(request_, task, identity_));
            task.key = request_key_ + key;
        }
        kept_ = kept_keys(tasks, *journal_, written_.empty());
        return {};
    }

    Status open_files(const OutputFile& output) {
        if (request_.resume && !output.seekable()) {
            return refused_value("-o", request_.output, "--resume needs a file");
        }
        if (!request_.database.empty()) {
            const auto waits = [this](const Diagnostic& waiting) {
                const std::lock_guard lock(mutex_);
                events_.warned({waiting});
            };
            auto opened = TRY(ResultsDatabase::open(request_.database,
                                                    ResultsDatabase::Access::write, job_, waits));
            identity_ = TRY(opened.identity());
            database_.emplace(std::move(opened));
        }
        auto journal = TRY(RowJournal::open(output.seekable() ? journal_of(request_.output) : "",
                                            request_.resume));
        journal_.emplace(std::move(journal));
        if (journal_->found() > 0) {
            events_.warned({{DiagnosticKind::earlier_rows,
                             {journal_of(request_.output),
                              count_arg(static_cast<std::int64_t>(journal_->found()))}}});
        }
        return {};
    }

    // Under --only the rows of other sets are theirs; in a watched folder, those of the same
    // request are of sets that left.
    void tell_other_rows(const std::vector<SetTask>& tasks) {
        const auto kept = request_.watch
                              ? std::ranges::count_if(journal_->rows(),
                                                      [this](const RowJournal::Row& row) {
                                                          return row.key.starts_with(request_key_);
                                                      })
                              : std::ranges::count_if(tasks, [this](const SetTask& task) {
                                    return journal_->has(task.key);
                                });
        const auto all = request_.watch ? std::ssize(journal_->rows())
                                        : static_cast<std::ptrdiff_t>(journal_->size());
        const std::int64_t others = all - kept;
        if (request_.only.empty() && others > 0) {
            events_.warned(
                {{DiagnosticKind::other_rows, {journal_of(request_.output), count_arg(others)}}});
        }
    }

    Status compute_rows(const MeasurementList& list, const std::vector<SetTask>& tasks,
                        const std::vector<std::string>& header, OutputFile& output) {
        const auto last_id = TRY(database_ ? database_->last_id() : Result<std::int64_t>(0));
        SetWork work(*this, tasks, last_id);
        Status done = work.run();
        LimitCounts counts;
        if (done) {
            done =
                write_table(output, request_, list, header, tasks, *journal_, request_key_, counts);
        }
        if (!done) {
            return as_left(done.error(), output, work.done(), std::ssize(tasks));
        }
        if (request_.watch) {
            return {};
        }
        journal_->remove();
        const auto without = std::ranges::count_if(
            tasks, [](const SetTask& task) { return task.limits && task.limits->empty(); });
        if (without > 0) {
            events_.warned({{DiagnosticKind::limits_missing,
                             {count_arg(without), count_arg(std::ssize(tasks))}}});
        }
        if (counts.failed + counts.undecided > 0) {
            events_.warned({{DiagnosticKind::limits_not_kept,
                             {count_arg(counts.failed), count_arg(counts.undecided),
                              count_arg(std::ssize(tasks))}}});
        }
        return {};
    }

    // The error that ends the batch; one of an interruption that leaves rows names --resume.
    // Removes a journal without rows.
    Error as_left(const Error& error, const OutputFile& output, std::size_t done,
                  std::int64_t sets) {
        if (journal_->empty()) {  // rows of other settings may be wanted again
            journal_->remove();
        }
        const bool kept = done > 0 && output.seekable();
        return error.code == ErrorCode::interrupted && kept
                   ? Error{ErrorCode::interrupted_midway,
                           output.name(),
                           {count_arg(static_cast<std::int64_t>(done)), count_arg(sets)}}
                   : output.as_it_stands(error);
    }

    // Computes the rows that the journal lacks, several sets at once. A set without a result has a
    // row, too; a fault of the machine (memory, threads, disk) or an interruption ends the work.
    class SetWork {
    public:
        // `last_id`: of the results in the database.
        SetWork(Batch& batch, const std::vector<SetTask>& tasks, std::int64_t last_id)
            : batch_(batch),
              tasks_(tasks),
              last_id_(last_id),
              interrupted_(batch.stop_, [this] { halt_.request_stop(); }) {
            for (const SetTask& task : tasks_) {
                if (!batch_.is_kept(task)) {
                    todo_.push_back(&task);
                }
            }
            done_ = tasks_.size() - todo_.size();
            prepare_sha256();
        }

        // Errors: out_of_memory, out_of_threads, interrupted, those of writing a file.
        Status run() {
            const std::size_t jobs =
                std::min(static_cast<std::size_t>(batch_.request_.jobs), todo_.size());
            {
                std::vector<std::jthread> workers;
                try {
                    while (workers.size() + 1 < jobs) {
                        workers.emplace_back([this] { work(); });
                    }
                } catch (const std::system_error&) {
                    give_up({ErrorCode::out_of_threads, {}, {}});
                }
                work();
            }
            return fault_ ? Status(*fault_) : Status();
        }

        // Rows in the journal.
        std::size_t done() const { return done_; }

    private:
        void work() {
            try {
                for (std::size_t k = next_++; k < todo_.size(); k = next_++) {
                    if (halt_.stop_requested()) {
                        give_up({ErrorCode::interrupted, {}, {}});
                        return;
                    }
                    finish(*todo_[k]);
                }
            } catch (...) {
                give_up(error_of(std::current_exception()));
            }
        }

        void finish(const SetTask& task) {
            if (task.fault) {
                add_failure(task, *task.fault, {});
                return;
            }
            const JobControl job(halt_.get_token(), {}, batch_.events_.clock);
            Result<OpenSet> open =
                open_set(with_threads(*task.set), task.passport, halt_.get_token());
            if (!open) {
                add_failure(task, open.error(), {});
                return;
            }
            Result<SetResult> result =
                identify_set(*open, batch_.request_.program, batch_.request_.compare, job);
            if (!result) {
                add_failure(task, result.error(), warnings_of(*open));
                return;
            }
            std::vector<NamedWarnings> warnings = warnings_of(*open, *result);
            const double identified = job.now();
            if (const Status kept = keep(task, *result, job, warnings); !kept) {
                give_up(kept.error());
                return;
            }
            add_row(task, {.fields = batch_row(*result, verdict_of(task, &result->identification)),
                           .warnings = std::move(warnings),
                           .timing = result->identification.timing,
                           .write_s = job.now() - identified});
        }

        // Writes what goes beside the row, before it: a row in the journal means that its files and
        // its result in the database are there.
        Status keep(const SetTask& task, const SetResult& result, const JobControl& job,
                    std::vector<NamedWarnings>& warnings) {
            if (!task.new_passport.empty()) {
                TRY(write_file(task.new_passport, passport_json(passport_of(result)), job));
            }
            if (!task.json.empty() || batch_.database_) {
                const std::string json = identify_json(result);
                TRY(task.json.empty() ? Status() : write_file(task.json, json, job));
                if (batch_.database_) {
                    auto stored = TRY(store(task, result, json));
                    if (!stored.empty()) {
                        warnings.emplace_back("", std::move(stored));
                    }
                }
            }
            return {};
        }

        // Precondition: there is a database. Returns the warning that it keeps one result for this
        // set and another one.
        Result<std::vector<Diagnostic>> store(const SetTask& task, const SetResult& result,
                                              const std::string& json) {
            const auto stored = TRY(stored_result(result, json));
            const std::lock_guard lock(database_mutex_);
            // Of two sets of the list the later one counts, whichever is computed first.
            const SetTask*& last = stored_[stored.key];
            if (last != nullptr && last > &task) {
                return same_recordings({last->set->name, gyro_of(*last->set)}, stored);
            }
            // The same numbers of the results whichever set is computed first.
            const std::int64_t place = &task - tasks_.data() + 1;
            const auto added = TRY(batch_.database_->add(stored, last_id_ + place));
            last = &task;
            return same_recordings(stored, added.replaced.value_or(stored));
        }

        void add_failure(const SetTask& task, const Error& error,
                         const std::vector<NamedWarnings>& warnings) {
            if (ends_all(error.code)) {
                give_up(error);
            } else {
                add_row(task, {.fields = batch_row(*task.set, error, verdict_of(task, nullptr)),
                               .warnings = warnings,
                               .error = error});
            }
        }

        void add_row(const SetTask& task, FinishedRow row) {
            const std::unique_lock lock(batch_.mutex_);
            const Status kept = batch_.journal_->append(task.key, csv_row(row.fields));
            if (!kept) {
                fault_ = fault_ ? fault_ : kept.error();
                halt_.request_stop();
                return;
            }
            ++done_;
            row.set = static_cast<std::size_t>(&task - tasks_.data());
            batch_.events_.finished(row);
        }

        // The first fault counts: the others follow from its stop.
        void give_up(const Error& error) {
            {
                const std::lock_guard lock(batch_.mutex_);
                fault_ = fault_ ? fault_ : error;
            }
            halt_.request_stop();
        }

        // The threads of the machine are shared by the sets that are computed at once.
        MeasurementSet with_threads(MeasurementSet set) const {
            if (batch_.request_.jobs > 1 && set.settings.threads == 0) {
                set.settings.threads = std::max(1, threads_of(0) / batch_.request_.jobs);
            }
            return set;
        }

        Batch& batch_;
        const std::vector<SetTask>& tasks_;
        std::int64_t last_id_;
        std::vector<const SetTask*> todo_;
        std::mutex database_mutex_;                     // a wait for other writers holds up no rows
        std::map<std::string, const SetTask*> stored_;  // by the key of the result
        std::stop_source halt_;
        std::stop_callback<std::function<void()>> interrupted_;
        std::atomic<std::size_t> next_{0};
        // Under the mutex of the batch:
        std::optional<Error> fault_;
        std::size_t done_ = 0;
    };

    const BatchRequest& request_;
    const BatchEvents& events_;
    std::mutex mutex_;  // of the events and the journal, while several threads work
    std::stop_token stop_;
    JobControl job_;
    std::vector<TypedLimit> limits_;
    std::optional<ResultsDatabase> database_;
    std::string identity_;     // of the database
    std::string request_key_;  // with which the keys of a watched folder's rows begin
    std::optional<RowJournal> journal_;
    std::set<std::string> kept_;        // keys of rows that need not be computed
    std::vector<std::string> written_;  // keys of the rows of the last table, in its order
};

}  // namespace

Status compute_batch(const BatchRequest& request, const BatchEvents& events, std::stop_token stop) {
    return Batch(request, events, std::move(stop)).compute();
}

}  // namespace vybeg
