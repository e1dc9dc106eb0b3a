#pragma once

#include "app/cli_log.h"
#include "app/cli_requests.h"
#include "core/base/result.h"

#include <stop_token>

namespace vybeg::cli {

inline constexpr const char* program = "vybeg-cli " VYBEG_VERSION;

// The subcommands. Each writes its warnings to `log` and returns its error, which the caller
// writes.
Status run_info(const InfoRequest& request, Log& log, std::stop_token stop);
Status run_analyze(const AnalyzeRequest& request, Log& log, std::stop_token stop);
Status run_identify(const IdentifyRequest& request, Log& log, std::stop_token stop);
Status run_drift(const DriftRequest& request, Log& log, std::stop_token stop);
Status run_batch(const BatchCommand& request, Log& log, std::stop_token stop);
Status run_simulate(const SimulateRequest& request, Log& log, std::stop_token stop);

}  // namespace vybeg::cli
