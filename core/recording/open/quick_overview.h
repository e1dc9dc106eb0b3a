#pragma once

#include "core/base/job_control.h"
#include "core/recording/envelope/envelope.h"
#include "core/recording/samples/open_options.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace vybeg {

// Approximate picture of a recording before it is open.
struct QuickOverview {
    double rate_hz = 0;  // about
    std::shared_ptr<const Envelope> envelope;
};

// First look at a long text file, because opening reads all of it. Its length is that of the time
// column, otherwise approximately that of the rows. Empty for files that open fast or cannot be
// opened; open_recording() reports the reason.
std::optional<QuickOverview> quick_overview(const std::filesystem::path& path,
                                            const OpenOptions& options, const JobControl& job);

}  // namespace vybeg
