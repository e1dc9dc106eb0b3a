#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/setting_table.h"
#include "core/output/output_file.h"
#include "core/output/spool.h"
#include "core/recording/samples/recording.h"
#include "core/track/track.h"

#include <span>
#include <string>
#include <vector>

namespace vybeg {

// The header of an analysed track: program ("vybeg-cli 0.1.0"), input with its SHA-256 and rate,
// every setting as used, f0, window residual, warnings. Without the "# ".
std::vector<std::string> track_header(const std::string& program, const Recording& recording,
                                      const std::string& sha256, const AnalysisSummary& analysis);

// Writes the track as CSV: header lines after "# ", one line of names, a row per window. Errors:
// output_failed, interrupted. The caller calls commit().
Status write_track_csv(OutputFile& file, const Track& track, std::span<const std::string> header,
                       const JobControl& job);

// Writer of a track during its computation. The rows are spooled until the header is known, because
// the last warnings come with the last window. Not for two threads at once.
class TrackCsvWriter {
public:
    // `file` must outlive the writer.
    TrackCsvWriter(OutputFile& file, const JobControl& job) : file_(file), rows_(file, job) {}

    Status append(const Track& rows);
    // `flagged`: rows that get a flag between spool and file.
    Status finish(std::span<const std::string> header, std::span<const FlaggedRows> flagged);

private:
    // Rows of the next blocks from the spool, as many as are converted at once.
    Result<Track> next_rows(std::size_t& block);

    OutputFile& file_;
    Spool rows_;                       // numbers, less than half the size of their text
    std::vector<std::size_t> blocks_;  // rows of each append()
};

}  // namespace vybeg
