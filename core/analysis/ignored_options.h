#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/settings.h"
#include "core/base/diagnostic.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <vector>

namespace vybeg {

// Options that change nothing beside the others: option_without_effect for each.
std::vector<Diagnostic> without_effect(const Settings& settings);
std::vector<Diagnostic> without_effect(const IdentifySettings& settings);
// Of what a log is, and, where there is one, of the analysis of it in place of a recording.
std::vector<Diagnostic> without_effect(const Settings& settings, const LogChoice& log);
// Of those that say how the recording is opened, beside what the file itself says.
std::vector<Diagnostic> without_effect(const OpenOptions& options, const Recording& recording);

}  // namespace vybeg
