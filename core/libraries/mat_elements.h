#pragma once

#include <string>

namespace vybeg {

// Why a MAT file of level 4 or 5 cannot be whole, by the lengths of its variables; empty where
// nothing speaks against it. libmatio does not compare them with the file's end, and gives
// whatever its buffer held for samples that are not there.
std::string mat_damage(const std::string& path);

}  // namespace vybeg
