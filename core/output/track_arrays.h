#pragma once

#include "core/output/output_file.h"
#include "core/output/track_columns.h"

#include <span>
#include <string>

namespace vybeg {

// Writes a track as MAT of level 5: a column of doubles (n x 1) per column, the flags and the
// header's lines as cells of texts (n x 1). Errors: output_failed, also for more rows than the
// format has room for; interrupted; those of TrackColumns.
Status write_track_mat(OutputFile& file, const TrackColumns& columns,
                       std::span<const std::string> header);

// Writes a track as NPZ, not packed: a float64 array per column, the flags and the header's lines
// as arrays of texts of fixed width (NumPy's U). Errors: output_failed, interrupted, those of
// TrackColumns.
Status write_track_npz(OutputFile& file, const TrackColumns& columns,
                       std::span<const std::string> header);

// Writes a track as HDF5: a contiguous float64 dataset per column in the root group, the flags and
// the header's lines as texts of fixed width in UTF-8. Errors: output_failed, also where libhdf5
// cannot be loaded; interrupted; those of TrackColumns.
Status write_track_hdf5(OutputFile& file, const TrackColumns& columns,
                        std::span<const std::string> header);

}  // namespace vybeg
