#pragma once

#include "core/analysis/analysis.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"
#include "core/residuals/residuals.h"

namespace vybeg {

// The residual of an analysis in a range, its distribution, spectrum and autocorrelation.
// Precondition and errors as of residual_samples().
Result<Residuals> find_residuals(const Recording& recording, const Analysis& analysis,
                                 const ResidualRange& range, const JobControl& job);

}  // namespace vybeg
