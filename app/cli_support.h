#pragma once

#include "app/cli_log.h"
#include "core/base/job_control.h"
#include "core/output/output_file.h"

#include <optional>
#include <stop_token>
#include <string>

namespace vybeg::cli {

// What the subcommands share.

// A monotonic clock, seconds.
double seconds_now();

// The longest part of the work, with its progress in the log.
JobControl job_of(std::stop_token stop, Log& log);
// Everything else: heard when it is to stop, without its own progress.
JobControl silent_job(std::stop_token stop);

// The file of an option; none where it is not given.
Result<std::optional<OutputFile>> open_named(const std::string& name, const JobControl& job);

// Text to standard output.
Status write_text(const std::string& text, const JobControl& job);

}  // namespace vybeg::cli
