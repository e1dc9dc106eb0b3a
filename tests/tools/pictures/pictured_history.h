#pragma once

#include "core/base/result.h"

#include <filesystem>

namespace vybeg::test {

// A small laboratory's database of simulated results for the pictures: two gyros, one of which has
// a result outside its limits. Errors: those of ResultsDatabase.
Status write_pictured_history(const std::filesystem::path& path);

}  // namespace vybeg::test
