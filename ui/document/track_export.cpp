#include "ui/document/track_export.h"

#include "core/output/track_file.h"
#include "core/output/track_header.h"
#include "core/recording/samples/file_changes.h"

namespace vybeg::ui {

Status exportTrackTo(const std::filesystem::path& path, const Recording& recording,
                     const Analysis& analysis, const std::string& program, const JobControl& job) {
    const Result<TrackFormat> format = track_format(path);
    if (!format) {
        return format.error();
    }
    const Result<std::string> hash = recording_sha256(recording, job);
    if (!hash) {
        return hash.error();
    }
    Result<OutputFile> file = OutputFile::create(path, job);
    if (!file) {
        return file.error();
    }
    const auto header = track_header(program, recording, *hash, analysis);
    if (Status written = write_track(*file, *format, analysis.track, header, job); !written) {
        return written;
    }
    return file->commit();
}

}  // namespace vybeg::ui
