#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/reader_rules.h"

#include <optional>

namespace vybeg {

// The rate by a column of times that count in `unit_s` seconds: it rises by even steps below a
// second, and does not count the rows. Nothing for any other column. Errors: those of reading;
// interrupted.
Result<std::optional<SampleRate>> rate_of_times(const SampleColumn& column, double unit_s,
                                                const JobControl& job);

}  // namespace vybeg
