#pragma once

#include "core/drift/drift_settings.h"

#include <string>

namespace vybeg {

// Rates of a drift are written in degrees per hour, as the trade has them.
double degrees_per_hour(double rad_per_s);
Estimate degrees_per_hour(Estimate rad_per_s);

// The drift of whole-angle logs as JSON (help, files.html).
std::string drift_json(const std::string& program, const DriftOutcome& outcome);

// Its bins as a table, CSV.
std::string drift_csv(const std::string& program, const DriftOutcome& outcome);

}  // namespace vybeg
