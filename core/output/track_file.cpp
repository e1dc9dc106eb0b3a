#include "core/output/track_file.h"

#include "core/output/output_paths.h"
#include "core/output/track_csv.h"
#include "core/output/track_hdf5.h"
#include "core/output/track_header.h"
#include "core/output/track_mat.h"
#include "core/output/track_npz.h"

#include <vector>

namespace vybeg {
namespace {

// Every format but CSV.
Status write_arrays(OutputFile& file, TrackFormat format, const TrackColumns& columns,
                    std::span<const std::string> header) {
    const std::vector<std::string> lines = single_lines(header);
    switch (format) {
        case TrackFormat::mat: return write_track_mat(file, columns, lines);
        case TrackFormat::hdf5: return write_track_hdf5(file, columns, lines);
        default: return write_track_npz(file, columns, lines);
    }
}

}  // namespace

Result<TrackFormat> track_format(const std::filesystem::path& target) {
    const std::string ending = file_ending(target);
    if (ending == ".npy") {
        return Error{ErrorCode::output_failed,
                     target.string(),
                     {words(VYBEG_MESSAGE("Words",
                                          "a NumPy file has room for one array only; let its name "
                                          "end in .npz"))}};
    }
    TRY(check_ending(target, {"", ".csv", ".txt", ".mat", ".h5", ".hdf5", ".npz"}));
    return ending == ".mat"                       ? TrackFormat::mat
           : ending == ".h5" || ending == ".hdf5" ? TrackFormat::hdf5
           : ending == ".npz"                     ? TrackFormat::npz
                                                  : TrackFormat::csv;
}

Status write_track(OutputFile& file, TrackFormat format, const Track& track,
                   std::span<const std::string> header, const JobControl& job) {
    return format == TrackFormat::csv ? write_track_csv(file, track, header, job)
                                      : write_arrays(file, format, MemoryColumns(track), header);
}

Status TrackWriter::finish(std::span<const std::string> header,
                           std::span<const FlaggedRows> flagged) {
    rows_.set_flagged(flagged);
    return format_ == TrackFormat::csv ? write_track_csv(file_, rows_, header)
                                       : write_arrays(file_, format_, rows_, header);
}

}  // namespace vybeg
