#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/settings.h"

#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// Command-line name without its dashes, and value as the command line takes it ("none" where the
// setting is not set).
using NamedValue = std::pair<std::string, std::string>;

// Every setting that has a part in the result, in the order of the command line's help: all but
// the number of threads. Numbers round-trip.
std::vector<NamedValue> settings_list(const Settings& settings);

// The same for an identification: the settings that have a part in it, and --model.
std::vector<NamedValue> settings_list(const IdentifySettings& settings);

// "auto", "structured" or "free", as --model takes it.
const char* model_name(FitOptions::Model model);

}  // namespace vybeg
