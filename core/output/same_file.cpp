#include "core/output/same_file.h"

#include <optional>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <system_error>
#include <unistd.h>

namespace vybeg {
namespace {

std::optional<struct stat> status_of(const std::filesystem::path& path) {
    struct stat status {};
    const int failed = path == "-" ? fstat(STDOUT_FILENO, &status) : stat(path.c_str(), &status);
    return failed == 0 ? std::optional(status) : std::nullopt;
}

bool is_null_device(const struct stat& status) {
    return S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 3);
}

}  // namespace

bool same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
    const auto first = status_of(one);
    const auto second = status_of(other);
    if (first && second) {
        return first->st_dev == second->st_dev && first->st_ino == second->st_ino &&
               !is_null_device(*first);
    }
    if (first || second || one == "-" || other == "-" || one.empty() || other.empty()) {
        return one == other && one == "-";
    }
    std::error_code failed;
    const auto canonical = weakly_canonical(absolute(one, failed), failed);
    if (failed) {
        return one == other;
    }
    const auto other_canonical = weakly_canonical(absolute(other, failed), failed);
    return failed ? one == other : canonical == other_canonical;
}

}  // namespace vybeg
