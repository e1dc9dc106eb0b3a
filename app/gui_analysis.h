#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "ui/values/shown_analysis.h"

#include <string>
#include <vector>

namespace vybeg::cli {

// What --figure and --report share: an analysis without a window. Errors and warnings go to
// standard error, one line each.

// Returns the exit status (help, files.html).
int fail(const Error& error);
int ended(const Status& done);
void warn(const std::vector<Diagnostic>& diagnostics);

// Checks what can be checked before the first recording is opened, and warns of settings without
// effect. Errors: setting_invalid, those of check_threads().
Status check_request(const std::string& option, const std::string& output,
                     const std::vector<std::string>& inputs, const Settings& settings);

// With its warnings. Errors: those of open_recording().
Result<Recording> open_warned(const std::string& input, const OpenOptions& options,
                              const JobControl& job);
// Likewise. Errors: those of analyse(), file_changed.
Result<Analysis> analyse_warned(const Recording& recording, const Settings& settings,
                                const JobControl& job);

// For display, in the style of that number; its name is the window.
ui::ShownAnalysis shown_analysis(const Recording& recording, Analysis analysis, int index);

}  // namespace vybeg::cli
