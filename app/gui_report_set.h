#pragma once

#include "core/analysis/measurement_list.h"
#include "core/analysis/settings.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "ui/report/report_content.h"

#include <string>
#include <vector>

namespace vybeg::cli {

// What a report shows of a set, computed from its recordings: checks, analyses in the windows of
// `track` with the set's signals, identification. What cannot be identified has its reason in it.
// Conditions of the set take precedence over `title`. Warnings go to standard error. Errors:
// conditions_differ, those of open_recording(), analyse(), inspect(), read_contents(),
// file_changed, interrupted.
Result<ui::ReportContent> report_of_set(const MeasurementSet& set, const Settings& track,
                                        const ui::ReportTitle& title, const JobControl& job);

}  // namespace vybeg::cli
