#pragma once

#include "core/analysis/set_result.h"

#include <string>

namespace vybeg::cli {

// The summary of an identification for people: what each wave did, resonator, modes, runs, drift
// function and, where there is one, the comparison; every number with its standard deviation, and u
// where it differs, or its reason.
std::string identify_text(const SetResult& result);

}  // namespace vybeg::cli
