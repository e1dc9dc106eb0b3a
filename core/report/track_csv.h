#pragma once

#include "core/analysis/analyse.h"
#include "core/report/output_file.h"
#include "core/report/settings_text.h"

#include <span>
#include <string>
#include <vector>

namespace vybeg {

// The header of an analysed track: program ("vybeg-cli 0.1.0"), input with its SHA-256 and rate,
// every setting as used, f0, window residual, warnings. Without the "# ".
std::vector<std::string> track_header(const std::string& program, const Recording& recording,
                                      const std::string& sha256, const Analysis& analysis);

// The track in the format of INTERFACE.md, section Track CSV: header lines behind "# ", one line of
// names, a row per window. Errors: output_failed, interrupted. commit() is left to the caller.
Status write_track_csv(OutputFile& file, const Track& track, std::span<const std::string> header,
                       const JobControl& job);

}  // namespace vybeg
