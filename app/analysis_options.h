#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/passport.h"
#include "core/analysis/settings.h"
#include "core/drift/drift_settings.h"
#include "core/recording/samples/open_options.h"

#include <CLI/CLI.hpp>

#include <string>

namespace vybeg::cli {

// The options that say how a recording is opened: --rate, --channels, --raw and --delimiter with
// their companions. `options` must outlive the parse.
void add_open_options(CLI::App& app, OpenOptions& options);

// How whole-angle logs are read, and their channels' tolerances. `settings` must outlive the parse.
void add_drift_settings(CLI::App& app, DriftSettings& settings);

// The options that say how it is analysed: --algorithm to --angle-zero, --threads.
// `settings` must outlive the parse. Their values are checked one by one here and together by
// validate().
void add_analysis_options(CLI::App& app, Settings& settings);

// Those of them that have a part in an identification, --model, --tolerance and what logs are.
// `settings` must outlive the parse.
void add_identify_options(CLI::App& app, IdentifySettings& settings);

// Those of them that say what a log in place of a recording is. `logs` must outlive the parse.
void add_log_choice(CLI::App& app, LogChoice& logs);

// --tolerance alone, for the window and its report. `settings` must outlive the parse.
void add_tolerance_option(CLI::App& app, IdentifySettings& settings);

// Those of a comparison: --f-limit. `options` must outlive the parse.
void add_compare_options(CLI::App& app, CompareOptions& options);

}  // namespace vybeg::cli
