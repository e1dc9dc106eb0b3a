#pragma once

#include "core/output/output_file.h"
#include "core/output/track_spool.h"
#include "core/track/track.h"

#include <span>
#include <string>

namespace vybeg {

// Writes the track as CSV: header lines after "# ", one line of names, a row per window. Errors:
// output_failed, interrupted. The caller calls commit().
Status write_track_csv(OutputFile& file, const Track& track, std::span<const std::string> header,
                       const JobControl& job);

// The same from a spool, with its flagged rows.
Status write_track_csv(OutputFile& file, const TrackSpool& rows,
                       std::span<const std::string> header);

}  // namespace vybeg
