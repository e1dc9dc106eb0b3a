#pragma once

#include "core/analysis/identify_settings.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/open/log_columns.h"
#include "core/recording/samples/open_options.h"
#include "core/resonator/model/power_run.h"

#include <filesystem>
#include <vector>

namespace vybeg {

// What the columns of a log without a phase may be: E, R, S, Q, or a, b, theta, those of a track,
// too.
const std::vector<ColumnRole>& roles_of_powers();
const std::vector<ColumnRole>& roles_of_waves();

// The columns of a log, at the times that the settings of the signal choose. Errors: those of
// read_log() and keep_times().
Result<LogTable> read_log_columns(const std::filesystem::path& path, const OpenOptions& options,
                                  const std::vector<ColumnWish>& wishes,
                                  const SignalSettings& signal, const JobControl& job);

// Reads a log of E, R, S, Q or of a, b, theta, as `columns` says, of the times that the settings of
// the signal choose, and applies their calibration but for the offsets. A delay of D needs f0_hz: a
// log without a phase has no frequency. Columns that are exchanged are refused where E or a is not
// the largest. Errors: setting_invalid, those of column_wishes(), read_log(), keep_times() and
// angle_factor().
Result<PowerRun> read_power_log(const std::filesystem::path& path, const OpenOptions& options,
                                const LogChoice& columns, const SignalSettings& signal,
                                const JobControl& job);

// Refuses a delay (s), which a log without a phase cannot take without a carrier.
Error refused_delay(const char* option, double delay_s);

}  // namespace vybeg
