#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/settings.h"
#include "core/base/setting_rows.h"

#include <cstddef>
#include <string>
#include <vector>

namespace vybeg {

// The settings of an analysis and of an identification, a row for each, in the order of the command
// line's help.
const std::vector<SettingRow<Settings>>& analysis_settings();
const std::vector<SettingRow<IdentifySettings>>& identify_settings();

// Logs in place of recordings; identify_settings() has the same rows.
const std::vector<SettingRow<LogChoice>>& log_settings();

// ORDER,BW of a lock-in's filter, and ,RATE where `rate_hz` is asked for. Errors: setting_invalid.
Result<LockIn> read_lock_in(const std::string& option, const std::string& text,
                            double* rate_hz = nullptr);

// Bounds of a number of an analysis, or of an identification alone, by its option's name without
// dashes and its place in the option's value: what validate() takes.
const Bounds& bounds_of(const std::string& name, std::size_t number = 0);

// Checks the settings without a recording, and that no value is so large or small that numbers
// computed with it lose their digits. Errors: setting_invalid with the setting's command-line
// name.
Status validate(const SignalSettings& settings);
Status validate(const Settings& settings);
Status validate(const IdentifySettings& settings);

// Every setting that has a part in the result; those of logs where they are given. Settings of
// single recordings are joined by "; " where they differ.
std::vector<NamedValue> settings_list(const Settings& settings);
std::vector<NamedValue> settings_list(const IdentifySettings& settings);

}  // namespace vybeg
