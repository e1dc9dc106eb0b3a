#pragma once

#include <filesystem>
#include <string>

namespace vybeg {

// The ending of a file's name with its point, in small letters (of A to Z): ".csv".
std::string file_ending(const std::filesystem::path& path);

}  // namespace vybeg
