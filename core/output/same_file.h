#pragma once

#include <filesystem>
#include <system_error>

namespace vybeg {

// The file that a path leads to, also where it does not exist yet: without links, of which the last
// may lead nowhere. `failed`: why this cannot be told.
std::filesystem::path end_of_links(const std::filesystem::path& path, std::error_code& failed);

// Whether two paths lead to one file: by device and inode where both exist (including both kinds of
// links), otherwise by the folder of the new file, also by device and inode (a folder that is
// mounted at two places is one), and its name. "-" is standard output. The null device
// is never the same file, because its output is discarded on purpose.
bool same_file(const std::filesystem::path& one, const std::filesystem::path& other);

}  // namespace vybeg
