#pragma once

#include "core/output/output_file.h"
#include "core/output/track_columns.h"

#include <span>
#include <string>

namespace vybeg {

// Writes a track as NPZ, not packed: a float64 array per column, the flags and the header's lines
// as arrays of texts of fixed width (NumPy's U). Errors: output_failed, interrupted, those of
// TrackColumns.
Status write_track_npz(OutputFile& file, const TrackColumns& columns,
                       std::span<const std::string> header);

}  // namespace vybeg
