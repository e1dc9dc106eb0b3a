#include "core/recording/samples/file_changes.h"

#include "core/recording/bytes/sha256.h"

namespace vybeg {

Result<std::string> recording_sha256(const Recording& recording, const JobControl& job) {
    if (!recording.file) {
        return file_sha256(recording.path, job);
    }
    Result<std::string> hash = file_sha256(*recording.file, job);
    const Status still = recording.file->unchanged();
    return still ? hash : still.error();
}

Status unchanged(const Recording& recording) {
    return recording.file ? recording.file->unchanged() : Status{};
}

}  // namespace vybeg
