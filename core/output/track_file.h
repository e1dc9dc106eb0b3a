#pragma once

#include "core/output/output_file.h"
#include "core/output/track_columns.h"
#include "core/track/track.h"

#include <filesystem>
#include <span>
#include <string>

namespace vybeg {

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
