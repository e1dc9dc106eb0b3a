#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/identify_settings.h"
#include "core/output/output_file.h"
#include "core/output/track_columns.h"
#include "core/recording/samples/recording.h"
#include "core/track/track.h"

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

enum class TrackFormat { csv, mat, hdf5, npz };

// Format by the ending of the name (.mat, .h5, .hdf5, .npz; upper case too); CSV under every other
// one but .npy, which has no room for several arrays. Errors: output_failed.
Result<TrackFormat> track_format(const std::filesystem::path& target);

// Writes a track; the same columns, numbers, flags and header lines in every format, in CSV header
// lines after "# ", one line of names, a row per window. `columns`: those of a track in memory, or
// of one that was spooled during its computation. Errors: output_failed, interrupted. The caller
// calls commit().
Status write_track(OutputFile& file, TrackFormat format, const TrackColumns& columns,
                   std::span<const std::string> header, const JobControl& job);
Status write_track(OutputFile& file, TrackFormat format, const Track& track,
                   std::span<const std::string> header, const JobControl& job);

}  // namespace vybeg
