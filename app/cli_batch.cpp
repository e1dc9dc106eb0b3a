#include "app/cli_commands.h"
#include "app/cli_support.h"
#include "core/batch/batch_request.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

namespace vybeg::cli {
namespace {

// Writes the events of a batch into the log.
class BatchLog {
public:
    // `print`: rows go to standard output as they come.
    BatchLog(Log& log, bool print) : log_(log), print_(print) {}

    BatchEvents events() {
        return {[this](const auto& warnings) { log_.warnings(warnings); },
                [this](const auto& list) { begin(list); }, [this](const auto& row) { add(row); },
                seconds_now, [this](const auto& error) { log_.fail(error); }};
    }

    void tell_timing(double batch_s, int jobs) const {
        say_timing({{"read_s", spent_.read_s},
                    {"carrier_s", spent_.carrier_s},
                    {"estimate_s", spent_.estimate_s},
                    {"fit_s", spent_.fit_s},
                    {"write_s", write_s_},
                    {"batch_s", batch_s},
                    {"sets", computed_},
                    {"windows", windows_},
                    {"threads", spent_.threads},
                    {"jobs", jobs}});
    }

private:
    void begin(const MeasurementList& list) {
        names_.clear();
        done_ = 0;
        for (const MeasurementSet& set : list.sets) {
            names_.push_back(set.name);
        }
    }
    void add(const FinishedRow& row) {
        ++done_;
        if (row.kept) {
            return;
        }
        ++computed_;
        if (print_) {
            std::fputs((row.text + "\n").c_str(), stdout);
            std::fflush(stdout);
        }
        spent_.read_s += row.timing.read_s;
        spent_.carrier_s += row.timing.carrier_s;
        spent_.estimate_s += row.timing.estimate_s;
        spent_.fit_s += row.timing.fit_s;
        spent_.threads = row.timing.threads;
        write_s_ += row.write_s;
        windows_ += row.windows;
        const std::string& name = names_[row.set];
        log_.warnings(row.warnings, name);
        if (row.error) {
            log_.fail(*row.error, name);
        }
        log_.progress(static_cast<double>(done_) / static_cast<double>(names_.size()));
    }

    Log& log_;
    bool print_;
    std::vector<std::string> names_;  // of the sets
    std::size_t done_ = 0;
    std::size_t computed_ = 0;
    IdentifyTiming spent_;  // summed over the sets that were computed
    double write_s_ = 0;
    std::int64_t windows_ = 0;
};

}  // namespace

Status run_batch(const BatchCommand& request, Log& log, std::stop_token stop) {
    BatchLog told(log, request.batch.watch);
    const double begun = seconds_now();
    const Status done = compute_batch(request.batch, told.events(), std::move(stop));
    if (done && request.timing) {
        told.tell_timing(seconds_now() - begun, request.batch.jobs);
    }
    return done;
}

}  // namespace vybeg::cli
