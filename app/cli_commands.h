#pragma once

#include "app/cli_log.h"
#include "core/analysis/identify.h"
#include "core/analysis/settings.h"
#include "core/recording/open_recording.h"
#include "core/resonator/passport.h"
#include "core/simulation/free_decay.h"

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

namespace vybeg::cli {

inline constexpr const char* program = "vybeg-cli " VYBEG_VERSION;

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
    bool timing = false;
};

// `identify` and, with a passport to compare with, `compare`.
struct IdentifyRequest {
    std::vector<std::string> inputs;
    std::string output;        // empty: a summary for people on standard output; "-": JSON there
    std::string new_passport;  // --passport; empty: none
    std::string old_passport;  // of compare; empty: none
    OpenOptions open;
    IdentifySettings settings;
    CompareOptions compare;
    bool timing = false;
};

struct SimulateRequest {
    std::string output;
    std::string truth;  // empty: none
    FreeDecay decay;
    std::int64_t window = 60;  // of the truth
};

// The subcommands. Each returns the program's exit status and has told `log` why.
int run_info(const InfoRequest& request, Log& log, std::stop_token stop);
int run_analyze(const AnalyzeRequest& request, Log& log, std::stop_token stop);
int run_identify(const IdentifyRequest& request, Log& log, std::stop_token stop);
int run_simulate(const SimulateRequest& request, Log& log, std::stop_token stop);

}  // namespace vybeg::cli
