#pragma once

#include <filesystem>

namespace vybeg {

// A file under a temporary name, `.vybeg-PID-START-N.part`, with the process that writes it and the
// time at which that process began, in the system's clock ticks. The descriptor is locked (flock)
// until it is closed.
struct TemporaryFile {
    int descriptor = -1;  // -1: it could not be made
    int error = 0;        // the system's number, why
    std::filesystem::path path;
};

// Makes one in `folder`, readable and writable, with the permissions of the umask. The name is
// short, so that it fits wherever the target's name does.
TemporaryFile make_temporary(const std::filesystem::path& folder);

// Removes abandoned temporary files in `folder` (after SIGKILL or loss of power). A file stays
// while its process runs on this machine, or while it is locked, for example by a process of
// another machine or container that shares the folder.
void remove_abandoned(const std::filesystem::path& folder);

}  // namespace vybeg
