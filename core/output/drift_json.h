#pragma once

#include "core/drift/drift_settings.h"
#include "core/drift/whole_angle_drift.h"
#include "core/drift/whole_angle_log.h"

#include <span>
#include <string>

namespace vybeg {

// Rates of a drift are written in degrees per hour, as the trade has them.
double degrees_per_hour(double rad_per_s);
Estimate degrees_per_hour(Estimate rad_per_s);

// The drift of whole-angle logs as JSON (help, files.html). `settings`: with which it was found.
std::string drift_json(const std::string& program, std::span<const WholeAngleLog> logs,
                       const DriftSettings& settings, const WholeAngleDrift& drift);

// Its bins as a table, CSV.
std::string drift_csv(const std::string& program, std::span<const WholeAngleLog> logs,
                      const DriftSettings& settings, const WholeAngleDrift& drift);

}  // namespace vybeg
