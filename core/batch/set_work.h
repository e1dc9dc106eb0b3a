#pragma once

#include "core/base/result.h"
#include "core/batch/batch_request.h"
#include "core/batch/identify_set.h"
#include "core/database/results_database.h"
#include "core/output/row_journal.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace vybeg {

// What the rows of a batch are made of, and where they go. All must outlive the work.
struct BatchWork {
    const BatchRequest& request;
    const std::vector<SetTask>& tasks;
    RowJournal& journal;
    ResultsDatabase* database = nullptr;  // null: there is none
    std::int64_t last_id = 0;             // of the results in it
    const BatchEvents& events;
    std::mutex& mutex;  // of the events and the journal
};

// Computes the rows that a journal lacks, several sets at once. A set without a result has a row,
// too; a fault of the machine (memory, threads, disk) or an interruption ends the work.
class SetWork {
public:
    SetWork(const BatchWork& batch, std::stop_token stop);

    // Errors: out_of_memory, out_of_threads, interrupted, those of writing a file.
    Status run();

    // Rows in the journal.
    std::size_t done() const { return done_; }

private:
    void work();
    void finish(const SetTask& task);
    // Writes what goes beside the row, before it: a row in the journal means that its files and its
    // result in the database are there.
    Status keep(const SetTask& task, const SetResult& result, const JobControl& job,
                std::vector<NamedWarnings>& warnings);
    // Precondition: there is a database. Returns the warning that it keeps one result for this set
    // and another one.
    Result<std::vector<Diagnostic>> store(const SetTask& task, const SetResult& result,
                                          const std::string& json);
    void add_failure(const SetTask& task, const Error& error,
                     const std::vector<NamedWarnings>& warnings);
    void add_row(const SetTask& task, FinishedRow row);
    void give_up(const Error& error);
    MeasurementSet with_threads(const MeasurementSet& set) const;

    const BatchWork batch_;
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

}  // namespace vybeg
