#include "app/cli_commands.h"
#include "core/batch/compute_batch.h"

#include <cstddef>
#include <mutex>
#include <string>
#include <utility>

namespace vybeg::cli {
namespace {

// Writes the events of a batch into the log.
class BatchLog {
public:
    explicit BatchLog(Log& log) : log_(log) {}

    BatchEvents events() {
        return {[this](const auto& warnings) { log_.warnings(warnings); },
                [this](const auto& list) { begin(list); }, [this](const auto& row) { add(row); },
                [this](double patience_s) { wait(patience_s); }};
    }

private:
    void begin(const MeasurementList& list) {
        for (const MeasurementSet& set : list.sets) {
            names_.push_back(set.name);
        }
    }
    void wait(double patience_s) {
        const std::lock_guard lock(mutex_);
        log_.waiting("database-in-use",
                     "The database is in use by another program; waiting up to " +
                         english(number_arg(patience_s, 3)) + " s.");
    }
    void add(const FinishedRow& row) {
        const std::lock_guard lock(mutex_);
        ++done_;
        if (row.kept) {
            return;
        }
        const std::string& name = names_[row.set];
        log_.warnings(row.warnings, name);
        if (row.error) {
            log_.fail(*row.error, name);
        }
        log_.progress(static_cast<double>(done_) / static_cast<double>(names_.size()));
    }

    Log& log_;
    std::mutex mutex_;                // a wait comes beside rows
    std::vector<std::string> names_;  // of the sets
    std::size_t done_ = 0;
};

}  // namespace

int run_batch(const BatchRequest& request, Log& log, std::stop_token stop) {
    BatchLog told(log);
    const Status done = compute_batch(request, told.events(), std::move(stop));
    return done ? 0 : log.fail(done.error());
}

}  // namespace vybeg::cli
