#pragma once

#include "app/cli_log.h"
#include "app/cli_requests.h"

#include <stop_token>

namespace vybeg::cli {

inline constexpr const char* program = "vybeg-cli " VYBEG_VERSION;

// The subcommands. Each returns the program's exit status and has told `log` why.
int run_info(const InfoRequest& request, Log& log, std::stop_token stop);
int run_analyze(const AnalyzeRequest& request, Log& log, std::stop_token stop);
int run_identify(const IdentifyRequest& request, Log& log, std::stop_token stop);
int run_drift(const DriftRequest& request, Log& log, std::stop_token stop);
int run_batch(const BatchCommand& request, Log& log, std::stop_token stop);
int run_simulate(const SimulateRequest& request, Log& log, std::stop_token stop);

}  // namespace vybeg::cli
