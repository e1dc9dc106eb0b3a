#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/passport.h"
#include "core/analysis/settings.h"
#include "core/batch/batch_request.h"
#include "core/drift/drift_settings.h"
#include "core/numerics/lock_in.h"
#include "core/recording/samples/open_options.h"
#include "core/simulation/free_decay.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vybeg::cli {

struct InfoRequest {
    std::string input;
    OpenOptions open;
    bool json = false;
    bool verbose = false;
    bool timing = false;
};

struct AnalyzeRequest {
    std::string input;
    std::string output;  // "-": standard output
    OpenOptions open;
    Settings settings;
    LogChoice log;  // the input is one, where it is given
    bool timing = false;
};

// `identify` and, with a passport to compare with, `compare`.
struct IdentifyRequest {
    std::vector<std::string> inputs;
    std::string list;          // in place of the inputs; empty: none
    std::string set;           // of the list; empty: its only one
    std::string output;        // empty: a summary for people on standard output; "-": JSON there
    std::string new_passport;  // --passport; empty: none
    std::string database;      // --database; empty: none
    std::string old_passport;  // of compare; empty: none
    OpenOptions open;
    IdentifySettings settings;
    CompareOptions compare;
    bool timing = false;
};

struct DriftRequest {
    std::vector<std::string> inputs;
    std::string output;  // empty: none; .json: the result, .csv: its bins; "-": bins
    bool json = false;   // on standard output, in place of the summary
    DriftSettings settings;
};

struct BatchCommand {
    BatchRequest batch;
    bool timing = false;
};

struct SimulateRequest {
    std::string output;
    std::string truth;  // empty: none
    bool timing = false;
    FreeDecay decay;
    std::int64_t window = 60;  // of the truth
    LockIn lock_in;            // order 0: none
    double lock_in_rate_hz = 0;
};

}  // namespace vybeg::cli
