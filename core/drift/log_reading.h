#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/drift/whole_angle_log.h"
#include "core/recording/samples/open_options.h"

#include <filesystem>
#include <string>

namespace vybeg {

// How a whole-angle log is read.
struct LogReading {
    OpenOptions open;
    std::string columns;            // t, theta, amplitude, quadrature as column_wishes() has them
    double rad_per_angle_unit = 0;  // 0: by the file

    friend bool operator==(const LogReading&, const LogReading&) = default;
};

// Whether a text is one of LogReading::columns. Errors: those of column_wishes().
Status check_log_columns(const std::string& columns);

// Errors: those of column_wishes(), read_log() and angle_factor().
Result<WholeAngleLog> read_whole_angle_log(const std::filesystem::path& path,
                                           const LogReading& reading, const JobControl& job);

}  // namespace vybeg
