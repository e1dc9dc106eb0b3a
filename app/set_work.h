#pragma once

#include "app/cli_log.h"
#include "app/cli_requests.h"
#include "app/set_identification.h"
#include "core/analysis/measurement_list.h"
#include "core/base/result.h"
#include "core/database/results_database.h"
#include "core/output/row_journal.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace vybeg::cli {

// One set of a batch, on its way to its row.
struct SetTask {
    const MeasurementSet* set = nullptr;
    std::string passport;  // file that it is compared with; empty: none
    std::string json;      // file of the result; empty: none
    std::string key;       // of its row
};

// Computes the rows that a journal lacks, several sets at once. A set without a result has a row,
// too; a fault of the machine (memory, threads, disk) or an interruption ends the work.
class SetWork {
public:
    // All must outlive the work. `other_columns` as the list's; `database`: null, there is none.
    SetWork(const BatchRequest& request, const std::vector<SetTask>& tasks,
            const std::vector<std::string>& other_columns, RowJournal& journal,
            ResultsDatabase* database, Log& log, std::stop_token stop);

    // Errors: out_of_memory, out_of_threads, interrupted, those of writing a file.
    Status run();

    // Rows in the journal.
    std::size_t done() const { return done_; }

private:
    void work();
    void finish(const SetTask& task);
    Status store(const SetTask& task, const OpenSet& open, const Identification& found,
                 const std::string& json);
    void add_failure(const SetTask& task, const Error& error,
                     const std::vector<NamedWarnings>& warnings);
    void add_row(const SetTask& task, const std::string& row,
                 const std::vector<NamedWarnings>& warnings, const std::optional<Error>& error);
    void give_up(const Error& error);
    MeasurementSet with_threads(const MeasurementSet& set) const;

    const BatchRequest& request_;
    const std::vector<SetTask>& tasks_;
    const std::vector<std::string>& other_columns_;
    std::vector<const SetTask*> todo_;
    RowJournal& journal_;
    ResultsDatabase* database_;
    std::mutex database_mutex_;  // of the one before: a wait for other writers holds up no rows
    Log& log_;
    std::stop_source halt_;
    std::stop_callback<std::function<void()>> interrupted_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;  // of all below, the journal and the log
    std::optional<Error> fault_;
    std::size_t done_ = 0;
};

}  // namespace vybeg::cli
