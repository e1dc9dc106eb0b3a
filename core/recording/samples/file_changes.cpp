#include "core/recording/samples/file_changes.h"

#include "core/recording/bytes/sha256.h"

#include <vector>

namespace vybeg {

Result<std::string> recording_sha256(const Recording& recording, const JobControl& job) {
    if (!recording.file) {
        return file_sha256(recording.path, job);
    }
    std::vector<const FileBytes*> files{recording.file.get()};
    for (const auto& more : recording.more_files) {
        files.push_back(more.get());
    }
    Result<std::string> hash = files_sha256(files, job);
    const Status still = unchanged(recording);
    return still ? hash : still.error();
}

Status unchanged(const Recording& recording) {
    if (recording.file) {
        TRY(recording.file->unchanged());
    }
    for (const auto& more : recording.more_files) {
        TRY(more->unchanged());
    }
    return {};
}

}  // namespace vybeg
