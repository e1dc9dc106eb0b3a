#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/identify_settings.h"
#include "core/recording/samples/recording.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// The header of an analysed track: program ("vybeg-cli 0.1.0"), input with its SHA-256 and rate,
// every setting as used, f0, window residual, warnings. Without the "# ".
std::vector<std::string> track_header(const std::string& program, const Recording& recording,
                                      const std::string& sha256, const AnalysisSummary& analysis);

// The same of the track of a log (analyse_log()).
std::vector<std::string> track_header(const std::string& program, const std::filesystem::path& log,
                                      const std::string& sha256, const LogChoice& choice,
                                      const AnalysisSummary& analysis);

// Header lines as they go into a file: a file name may contain a line feed, a line may not.
std::vector<std::string> single_lines(std::span<const std::string> header);

}  // namespace vybeg
