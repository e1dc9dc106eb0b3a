#pragma once

#include "app/cli_requests.h"

#include <CLI/CLI.hpp>

#include <string>
#include <utility>
#include <vector>

namespace vybeg::cli {

// The options of `simulate`. `request` must outlive the parse.
void add_simulate_options(CLI::App& app, SimulateRequest& request);

// The decay as (option name without dashes, value text), in the order of the help.
std::vector<std::pair<std::string, std::string>> decay_list(const FreeDecay& decay);

}  // namespace vybeg::cli
