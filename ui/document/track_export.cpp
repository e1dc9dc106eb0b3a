#include "ui/document/track_export.h"

#include "core/output/track_file.h"
#include "core/output/track_header.h"
#include "core/recording/samples/file_changes.h"

namespace vybeg::ui {

Status exportTrackTo(const std::filesystem::path& path, const Recording& recording,
                     const Analysis& analysis, const std::string& program, const JobControl& job) {
    const auto format = TRY(track_format(path));
    const auto hash = TRY(recording_sha256(recording, job));
    auto file = TRY(OutputFile::create(path, job));
    const auto header = track_header(program, recording, hash, analysis);
    TRY(write_track(file, format, analysis.track, header, job));
    return file.commit();
}

}  // namespace vybeg::ui
