#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace vybeg {

// The ending of a file's name with its point, in small letters (of A to Z): ".csv".
std::string file_ending(const std::filesystem::path& path);

// Whether a file's ending is one of these; "" among them: it may have none. Errors:
// output_format_unknown, with what can be written.
Status check_ending(const std::filesystem::path& path,
                    std::initializer_list<std::string_view> endings);

}  // namespace vybeg
