#pragma once

#include <filesystem>

namespace vybeg {

// Whether two paths lead to one file: by device and inode where both exist (links of both kinds
// included), else by the canonical path that a new file would have. "-" is standard output. The
// null device is never the same file: what goes there is lost on purpose.
bool same_file(const std::filesystem::path& one, const std::filesystem::path& other);

}  // namespace vybeg
