#pragma once

#include "app/cli_support.h"
#include "core/analysis/identify.h"
#include "core/analysis/passport.h"
#include "core/analysis/settings.h"
#include "core/base/result.h"
#include "core/batch/batch_request.h"
#include "core/drift/drift_settings.h"
#include "core/numerics/lock_in.h"
#include "core/recording/samples/open_options.h"
#include "core/simulation/free_decay.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

namespace vybeg::cli {

struct InfoRequest {
    std::string input;
    OpenOptions open;
    bool json = false;
};

struct AnalyzeRequest {
    std::string input;
    std::string output;  // "-": standard output
    OpenOptions open;
    Settings settings;
    LogChoice log;  // the input is one, where it is given
};

// `identify` and, with a passport to compare with, `compare`.
struct IdentifyRequest : NamedRecordings {
    std::string output;        // empty: a summary for people on standard output; "-": JSON there
    std::string new_passport;  // --passport; empty: none
    std::string database;      // --database; empty: none
    std::string old_passport;  // of compare; empty: none
    IdentifySettings settings;
    CompareOptions compare;
};

struct DriftRequest {
    std::vector<std::string> inputs;
    std::string output;  // empty: none; .json: the result, .csv: its bins; "-": bins
    bool json = false;   // on standard output, in place of the summary
    DriftSettings settings;
};

struct SimulateRequest {
    std::string output;
    std::string truth;  // empty: none
    FreeDecay decay;
    std::int64_t window = WindowSettings().window;  // of the truth
    LockIn lock_in;                                 // order 0: none
    double lock_in_rate_hz = 0;
};

inline constexpr const char* program = "vybeg-cli " VYBEG_VERSION;

// The subcommands. Each writes its warnings to `log` and returns its error, which the caller
// writes.
Status run_info(const InfoRequest& request, Log& log, std::stop_token stop);
Status run_analyze(const AnalyzeRequest& request, Log& log, std::stop_token stop);
Status run_identify(const IdentifyRequest& request, Log& log, std::stop_token stop);
Status run_drift(const DriftRequest& request, Log& log, std::stop_token stop);
Status run_batch(const BatchRequest& request, Log& log, std::stop_token stop);
Status run_simulate(const SimulateRequest& request, Log& log, std::stop_token stop);

// The options of `simulate`. `request` must outlive the parse.
void add_simulate_options(CLI::App& app, SimulateRequest& request);

}  // namespace vybeg::cli
