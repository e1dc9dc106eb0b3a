#pragma once

#include <string>
#include <string_view>

namespace vybeg {

// What stands before the numbers of a NumPy array: `type` as "<f8", `shape` as "5, 2" or "5,".
std::string npy_head(std::string_view type, std::string_view shape);

}  // namespace vybeg
