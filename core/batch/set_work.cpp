#include "core/batch/set_work.h"

#include "core/base/error.h"
#include "core/output/batch_csv.h"
#include "core/output/output_file.h"
#include "core/output/passport_json.h"
#include "core/recording/bytes/sha256.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <system_error>
#include <thread>
#include <utility>

namespace vybeg {
namespace {

// Faults that are no property of a set: they end the batch, and the set is computed again later.
bool ends_batch(ErrorCode code) {
    const int status = exit_status(code);
    return code == ErrorCode::out_of_memory || code == ErrorCode::out_of_threads ||
           status == exit_status(ErrorCode::output_failed) ||
           status == exit_status(ErrorCode::interrupted);
}

// None where the table has no limits.
std::optional<LimitVerdict> verdict_of(const SetTask& task, const Identification* found) {
    return task.limits ? std::optional(limit_verdict(found, *task.limits)) : std::nullopt;
}

}  // namespace

SetWork::SetWork(const BatchWork& batch, std::stop_token stop)
    : batch_(batch), interrupted_(std::move(stop), [this] { halt_.request_stop(); }) {
    for (const SetTask& task : batch_.tasks) {
        if (!batch_.journal.has(task.key)) {
            todo_.push_back(&task);
        }
    }
    done_ = batch_.tasks.size() - todo_.size();
    prepare_sha256();
}

Status SetWork::run() {
    const std::size_t jobs = std::min(static_cast<std::size_t>(batch_.request.jobs), todo_.size());
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
    const JobControl job(halt_.get_token(), {}, batch_.events.clock);
    Result<OpenSet> open = open_set(set, task.passport, halt_.get_token());
    if (!open) {
        add_failure(task, open.error(), {});
        return;
    }
    Result<SetResult> result =
        identify_set(*open, batch_.request.program, batch_.request.compare, job);
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
    const std::optional<LimitVerdict> limits = verdict_of(task, &result->identification);
    FinishedRow row{.fields = batch_row(*result, limits ? &*limits : nullptr),
                    .warnings = std::move(warnings),
                    .error = {},
                    .timing = result->identification.timing,
                    .write_s = job.now() - identified};
    for (const IdentifiedRun& run : result->identification.runs) {
        row.windows += run.windows;
    }
    add_row(task, std::move(row));
}

Status SetWork::keep(const SetTask& task, const SetResult& result, const JobControl& job,
                     std::vector<NamedWarnings>& warnings) {
    if (!task.new_passport.empty()) {
        TRY(write_file(task.new_passport, passport_json(passport_of(result)), job));
    }
    if (!task.json.empty() || batch_.database != nullptr) {
        const std::string json = identify_json(result);
        TRY(task.json.empty() ? Status() : write_file(task.json, json, job));
        if (batch_.database != nullptr) {
            auto stored = TRY(store(task, result, json));
            if (!stored.empty()) {
                warnings.emplace_back("", std::move(stored));
            }
        }
    }
    return {};
}

Result<std::vector<Diagnostic>> SetWork::store(const SetTask& task, const SetResult& result,
                                               const std::string& json) {
    std::vector<Diagnostic> warnings;
    const auto stored = TRY(stored_result(result, json));
    const std::lock_guard lock(database_mutex_);
    const auto holder = TRY(batch_.database->holder(stored.key));
    // Of two sets of the list the later one counts, whichever is computed first.
    const SetTask*& last = stored_[stored.key];
    const bool holds_later = last != nullptr && last > &task;
    const StoredName own{stored.set, stored.gyro};
    if (holder && *holder != own) {
        warnings.push_back(holds_later ? same_recordings(*holder, own)
                                       : same_recordings(own, *holder));
    }
    if (!holds_later) {
        // The same numbers of the results whichever set is computed first.
        const std::int64_t place = &task - batch_.tasks.data() + 1;
        TRY(batch_.database->add(stored, batch_.last_id + place));
        last = &task;
    }
    return warnings;
}

void SetWork::add_failure(const SetTask& task, const Error& error,
                          const std::vector<NamedWarnings>& warnings) {
    if (ends_batch(error.code)) {
        give_up(error);
    } else {
        const std::optional<LimitVerdict> limits = verdict_of(task, nullptr);
        add_row(task, {.fields = batch_row(*task.set, error, limits ? &*limits : nullptr),
                       .warnings = warnings,
                       .error = error,
                       .timing = {}});
    }
}

void SetWork::add_row(const SetTask& task, FinishedRow row) {
    const std::unique_lock lock(batch_.mutex);
    const Status kept = batch_.journal.append(task.key, csv_row(row.fields));
    if (!kept) {
        fault_ = fault_ ? fault_ : kept.error();
        halt_.request_stop();
        return;
    }
    ++done_;
    row.set = static_cast<std::size_t>(&task - batch_.tasks.data());
    batch_.events.finished(row);
}

// The first fault counts: the others follow from its stop.
void SetWork::give_up(const Error& error) {
    {
        const std::lock_guard lock(batch_.mutex);
        fault_ = fault_ ? fault_ : error;
    }
    halt_.request_stop();
}

// The threads of the machine are shared by the sets that are computed at once.
MeasurementSet SetWork::with_threads(const MeasurementSet& set) const {
    MeasurementSet own = set;
    if (batch_.request.jobs > 1 && own.settings.threads == 0) {
        own.settings.threads = std::max(1, threads_of(0) / batch_.request.jobs);
    }
    return own;
}

}  // namespace vybeg
