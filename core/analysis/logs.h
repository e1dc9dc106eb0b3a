#pragma once

#include "core/analysis/identify_settings.h"
#include "core/base/diagnostic.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/open/log_columns.h"
#include "core/recording/samples/open_options.h"
#include "core/resonator/model/power_run.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace vybeg {

// A log of phasors as windows: rows of a table, several averaged into one where they are close, on
// the times at which the lock-in's filter took them.
struct PhasorLog {
    PhasorRun run;       // without a rate of samples, of which a break might have lost some
    double rate_hz = 0;  // of the rows
    std::int64_t rows = 0;
    std::int64_t rows_per_window = 0;
    double noise_sd = 0;  // of a row, recording units
    // phasors_mirrored, reference_follows, oscillator_backward, channels_unequal, without the
    // recording as first argument.
    std::vector<Diagnostic> warnings = {};
};

// A log, and how it is read: of the signal's settings the times and the calibration but for the
// offsets.
struct LogFile {
    const std::filesystem::path& path;
    const OpenOptions& options;
    const LogChoice& choice;
    const SignalSettings& signal;
    const JobControl& job;
};

// angle_factor() of one of its columns.
inline Result<double> rad_per_unit(const LogFile& file, const LogColumn& angles) {
    return angle_factor(file.path, angles, file.choice.rad_per_angle_unit);
}

// What the columns of a log of phasors may be: of both channels in one table, or of one channel in
// a table of its own.
std::vector<ColumnRole> roles_of_both(PhasorFrame frame);
std::vector<ColumnRole> roles_of_one(PhasorFrame frame);

// Frequency by which an unwrapped phase goes on by more than half a turn from row to row, Hz: the
// carrier's part in it; 0 of any other phase. `rad`: per unit of the column.
double carrier_in(double rad, const LogColumn& phase, const std::vector<double>& time_s);

// Whether a column F holds the deviations of a frequency, about 0, in place of it; `f_ref_hz`: of
// the reference, 0: not stated.
bool holds_deviations(const LogColumn& frequency, double f_ref_hz);

// Reads a log of a lock-in or a phasemeter in the frame that the choice declares. One table holds
// both channels, or options.channel_d_file the one of D. A filter of the lock-in delays and
// lowers the phasors, and correlates their noise; it leaves frequencies, decay and axes as they
// are, because it commutes with the motion. The remainder at twice the carrier is taken out
// (remove_image()). The noise is the residual of a linear recurrence z(t + T) = A z(t). A frame
// that the rows contradict is an error. Errors: setting_invalid, rate_unknown, too_few_frames,
// those of column_wishes(), read_log() and angle_factor().
Result<PhasorLog> read_phasor_log(const LogFile& file);

// What the columns of a log without a phase may be: E, R, S, Q, or a, b, theta, those of a track,
// too.
const std::vector<ColumnRole>& roles_of_powers();
const std::vector<ColumnRole>& roles_of_waves();

// The columns of a log, at the times that the settings of the signal choose. Errors: those of
// read_log() and keep_times().
Result<LogTable> read_log_columns(const LogFile& file, const std::vector<ColumnWish>& wishes);

// Reads a log of E, R, S, Q or of a, b, theta, as the choice says. A delay of D needs f0_hz: a log
// without a phase has no frequency. Columns that are exchanged are refused where E or a is not
// the largest. Errors: setting_invalid, those of column_wishes(), read_log(), keep_times() and
// angle_factor().
Result<PowerRun> read_power_log(const LogFile& file);

// Refuses a delay (s), which a log without a phase cannot take without a carrier.
Error refused_delay(const char* option, double delay_s);

}  // namespace vybeg
