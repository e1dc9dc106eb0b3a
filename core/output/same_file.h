#pragma once

#include <filesystem>

namespace vybeg {

// Whether two paths lead to one file: by device and inode where both exist (including both kinds of
// links), otherwise by the folder of the new file, also by device and inode (a folder that is
// mounted at two places is one), and its name. "-" is standard output. The null device
// is never the same file, because its output is discarded on purpose.
bool same_file(const std::filesystem::path& one, const std::filesystem::path& other);

}  // namespace vybeg
