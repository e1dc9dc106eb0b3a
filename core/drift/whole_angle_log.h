#pragma once

#include "core/analysis/identify_settings.h"
#include "core/base/diagnostic.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace vybeg {

// What a controller writes down while it holds the amplitude and the wave turns: a row for each
// instant.
struct WholeAngleLog {
    std::string name;
    std::string sha256;          // of the file; empty: not from a file
    std::vector<double> time_s;  // rising
    std::vector<double> theta;   // wave angle theta_A, rad, whole or wrapped; NaN where missing
    // Of the controller, in any unit that both share; empty: not written down. The amplitude effort
    // is positive where it raises a_A, the quadrature effort where it raises a_B.
    std::vector<double> amplitude_effort;
    std::vector<double> quadrature_effort;
};

// A part of a log along which the angle is continuous.
struct AngleStretch {
    std::vector<std::size_t> rows;  // of the log; those without an angle are left out
    std::vector<double> time_s;
    std::vector<double> theta;  // unwrapped, rad
};

struct UnwrappedAngle {
    std::vector<AngleStretch> stretches;
    double period = 0;  // at which the log wraps its angle, rad: pi/2, pi or 2 pi; 0: it is whole
    // Of the whole log, rad: greatest less least angle of the longest stretch.
    double turn = 0;
    // A wrapped angle goes on by an eighth of a turn or more from row to row: how far is unknown.
    bool too_fast = false;
    // angle_jumps, where a stretch ends for that, and angle_coarse; without the log's name.
    std::vector<Diagnostic> warnings = {};
    // By which the angle comes back, rad, where it wraps at no quarter, half or whole turn: its
    // unit is another one. 0: it does not.
    double odd_period = 0;
};

// The angle of a log, made continuous. An angle that the controller wraps comes back by whole
// quarters of a turn, whatever its period; across a gap it is the nearest one to the turn so far,
// and where the gap is too long for that a new stretch begins, as where the angle jumps. An angle
// beyond one turn is whole.
UnwrappedAngle unwrapped_angle(const WholeAngleLog& log);

// Whether a text names the columns of a whole-angle log: t, theta, amplitude, quadrature as
// column_wishes() has them. Errors: those of column_wishes().
Status check_log_columns(const std::string& columns);

// Errors: those of column_wishes(), read_log() and angle_factor().
Result<WholeAngleLog> read_whole_angle_log(const std::filesystem::path& path,
                                           const OpenOptions& options, const LogChoice& choice,
                                           const JobControl& job);

}  // namespace vybeg
