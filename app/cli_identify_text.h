#pragma once

#include "core/output/identify_json.h"

#include <span>
#include <string>

namespace vybeg::cli {

// The summary of an identification for people: what each wave did, resonator, modes, runs, drift
// function and, where there is one, the comparison; every number with its standard deviation, and u
// where it differs, or its reason.
std::string identify_text(std::span<const IdentifiedInput> inputs,
                          const Identification& identification,
                          const PassportComparison* comparison);

}  // namespace vybeg::cli
