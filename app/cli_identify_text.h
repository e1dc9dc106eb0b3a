#pragma once

#include "core/analysis/passport.h"

#include <string>

namespace vybeg::cli {

// "1.00034 ± 0.00005 Hz, u 0.0003", "(1.03 ± 0.03)e-6 Hz", or the reason.
std::string text_of(const Estimate& estimate, const std::string& unit);
// The same of an angle in rad: angles for people are in degrees.
std::string text_in_degrees(const Estimate& estimate);
// A line of a summary.
std::string line(const std::string& name, const std::string& text);

// The summary of an identification for people: what each wave did, resonator, modes, runs, drift
// function and, where there is one, the comparison; every number with its standard deviation, and u
// where it differs, or its reason.
std::string identify_text(const SetResult& result);

}  // namespace vybeg::cli
