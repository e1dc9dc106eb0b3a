#pragma once

#include "core/base/job_control.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/text/text_scan.h"
#include "core/recording/text/text_table.h"
#include "core/recording/times/time_grid.h"

#include <memory>

namespace vybeg {

// The samples of a table on demand: only the places of its rows are kept in memory. Large reads are
// spread over threads. Where the times have gaps, their frames are NaN. Precondition: the table has
// no time column, or scan.even.
std::shared_ptr<const SampleSource> text_source(const TextTable& table, const TextScan& scan);

// The whole table in memory, with its times. Errors: file_read_failed, interrupted.
Result<TimedSamples> read_timed_rows(const TextTable& table, const TextScan& scan,
                                     const JobControl& job);

}  // namespace vybeg
