#pragma once

#include "core/analysis/identify_settings.h"
#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/open/preview.h"
#include "core/recording/samples/open_options.h"

#include <filesystem>
#include <optional>

namespace vybeg {

// The settings of a log that its file determines, and those that it leaves open.
struct LogLook {
    RecordingPreview preview;  // its first lines; of files that are no text there are none
    LogChoice choice;          // the settings given, completed by the file; not given() where its
                               // columns are not known by their names
    bool one_channel = false;  // phasors of one channel: the other has a file of its own
    bool needs_rate = false;   // neither times nor the clock of its ticks
    bool needs_angle_unit = false;
    bool needs_f_ref = false;
    std::optional<Error> problem;  // why it cannot be read as `choice` says
};

// Looks at a file by the columns that the readers of logs know (logs.h). Its kind
// and frame follow from the columns that are there: phases of both channels, or the
// frequency or phase of an oscillator, which is fixed where its frequency does not move. The sign
// of Y and peak or rms follow from no data; those of LabOne are the ones of its manual (X + iY
// turns as the carrier does, rms). What `given` sets stays. Errors: those of preview_recording(),
// interrupted.
Result<LogLook> look_at_log(const std::filesystem::path& path, const OpenOptions& options,
                            const LogChoice& given, const JobControl& job);

}  // namespace vybeg
