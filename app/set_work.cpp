#include "app/set_work.h"

#include "app/cli_commands.h"
#include "app/cli_support.h"
#include "app/process_guard.h"
#include "app/set_identification.h"
#include "core/output/batch_csv.h"
#include "core/recording/bytes/sha256.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <system_error>
#include <thread>
#include <utility>

namespace vybeg::cli {
namespace {

// Faults that are no property of a set: they end the batch, and the set is computed again later.
bool ends_batch(ErrorCode code) {
    const int status = exit_status(code);
    return code == ErrorCode::out_of_memory || code == ErrorCode::out_of_threads ||
           status == exit_status(ErrorCode::output_failed) ||
           status == exit_status(ErrorCode::interrupted);
}

}  // namespace

SetWork::SetWork(const BatchRequest& request, const std::vector<SetTask>& tasks,
                 const std::vector<std::string>& other_columns, RowJournal& journal,
                 ResultsDatabase* database, Log& log, std::stop_token stop)
    : request_(request),
      tasks_(tasks),
      other_columns_(other_columns),
      journal_(journal),
      database_(database),
      log_(log),
      interrupted_(std::move(stop), [this] { halt_.request_stop(); }) {
    for (const SetTask& task : tasks_) {
        if (!journal_.has(task.key)) {
            todo_.push_back(&task);
        }
    }
    done_ = tasks_.size() - todo_.size();
    prepare_sha256();
}

Status SetWork::run() {
    const std::size_t jobs = std::min(static_cast<std::size_t>(request_.jobs), todo_.size());
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

void SetWork::work() {
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

void SetWork::finish(const SetTask& task) {
    const MeasurementSet set = with_threads(*task.set);
    const JobControl job = silent_job(halt_.get_token());
    Result<OpenSet> open = open_set(set, task.passport, halt_.get_token());
    if (!open) {
        add_failure(task, open.error(), {});
        return;
    }
    const Result<IdentifiedSet> result = identify_set(*open, set, request_.compare, job);
    if (!result) {
        add_failure(task, result.error(), warnings_of(*open));
        return;
    }
    const PassportComparison* const compared = open->comparison ? &*open->comparison : nullptr;
    // Before the row: a row in the journal means that its file and its result in the database are
    // there.
    if (!task.json.empty() || database_ != nullptr) {
        const std::string json = identify_json(program, open->told, result->found, compared);
        Status written = task.json.empty() ? Status() : write_file(task.json, json, job);
        written = written ? store(task, *open, result->found, json) : written;
        if (!written) {
            give_up(written.error());
            return;
        }
    }
    add_row(task, batch_row(set, result->found, compared), result->warnings, {});
}

Status SetWork::store(const SetTask& task, const OpenSet& open, const Identification& found,
                      const std::string& json) {
    if (database_ == nullptr) {
        return {};
    }
    const Result<StoredResult> stored =
        stored_result(program, *task.set, other_columns_, open.told, found, json);
    if (!stored) {
        return stored.error();
    }
    const std::lock_guard lock(database_mutex_);
    const Result<std::int64_t> added = database_->add(*stored);
    return added ? Status() : added.error();
}

void SetWork::add_failure(const SetTask& task, const Error& error,
                          const std::vector<NamedWarnings>& warnings) {
    if (ends_batch(error.code)) {
        give_up(error);
    } else {
        add_row(task, batch_row(*task.set, error), warnings, error);
    }
}

void SetWork::add_row(const SetTask& task, const std::string& row,
                      const std::vector<NamedWarnings>& warnings,
                      const std::optional<Error>& error) {
    const std::unique_lock lock(mutex_);
    const Status kept = journal_.append(task.key, row);
    if (!kept) {
        fault_ = fault_ ? fault_ : kept.error();
        halt_.request_stop();
        return;
    }
    const std::string& name = task.set->name;
    for (const auto& [about, diagnostics] : warnings) {
        log_.warnings(diagnostics, about.empty() || about == name ? name : name + ", " + about);
    }
    if (error) {
        log_.fail(*error, name);
    }
    ++done_;
    log_.progress(static_cast<double>(done_) / static_cast<double>(tasks_.size()));
}

// The first fault counts: the others follow from its stop.
void SetWork::give_up(const Error& error) {
    {
        const std::lock_guard lock(mutex_);
        fault_ = fault_ ? fault_ : error;
    }
    halt_.request_stop();
}

// The threads of the machine are shared by the sets that are computed at once.
MeasurementSet SetWork::with_threads(const MeasurementSet& set) const {
    MeasurementSet own = set;
    if (request_.jobs > 1 && own.settings.threads == 0) {
        own.settings.threads = std::max(1, threads_of(0) / request_.jobs);
    }
    return own;
}

}  // namespace vybeg::cli
