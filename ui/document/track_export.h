#pragma once

#include "core/analysis/analysis.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"

#include <filesystem>
#include <string>

namespace vybeg::ui {

// Writes the track of an analysis, format by the ending of `path`; `program` goes into its header.
// Errors: those of track_format(), recording_sha256() and OutputFile.
Status exportTrackTo(const std::filesystem::path& path, const Recording& recording,
                     const Analysis& analysis, const std::string& program, const JobControl& job);

}  // namespace vybeg::ui
