#pragma once

#include <string>

namespace vybeg {

// Why a MAT file of level 4 or 5 cannot be whole, by the lengths of its variables and of the arrays
// in them; empty where nothing speaks against it. libmatio does not compare them with each other
// and with the file's end, and gives whatever stands behind, or its buffer held, for samples that
// are not there. Compressed variables are not looked into.
std::string mat_damage(const std::string& path);

}  // namespace vybeg
