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

// The track in the format of INTERFACE.md, section Track CSV: header lines behind "# ", one line of
// names, a row per window. Errors: output_failed, interrupted. commit() is left to the caller.
Status write_track_csv(OutputFile& file, const Track& track, std::span<const std::string> header,
                       const JobControl& job);

// The same of a track that is still being made, by a program that learns its last warnings with the
// last window: the rows wait in a spool for their header. Not for two threads at once.
class TrackCsvWriter {
public:
    // `file` must outlive the writer.
    TrackCsvWriter(OutputFile& file, const JobControl& job) : file_(file), rows_(file, job) {}

    Status append(const Track& rows);
    // `flagged`: rows that get a flag on their way from the spool into the file.
    Status finish(std::span<const std::string> header, std::span<const FlaggedRows> flagged);

private:
    // Rows from the spool, of that block and those after it, as many as become text at once.
    Result<Track> next_rows(std::size_t& block);

    OutputFile& file_;
    Spool rows_;                       // numbers: less than half of their text
    std::vector<std::size_t> blocks_;  // rows of each append()
};

}  // namespace vybeg
