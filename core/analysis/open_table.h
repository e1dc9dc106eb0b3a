#pragma once

#include "core/analysis/setting_rows.h"
#include "core/recording/samples/open_options.h"

#include <vector>

namespace vybeg {

// How a recording is opened, a row for each option, in the order of the command line's help: an
// option that needs another one comes after it. check_options() checks the values together.
const std::vector<SettingRow<OpenOptions>>& open_settings();

}  // namespace vybeg
