#pragma once

#include "core/base/job_control.h"
#include "core/recording/envelope/envelope.h"
#include "core/recording/samples/open_options.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace vybeg {

// A recording as it looks before it is open.
struct FirstLook {
    double rate_hz = 0;  // about
    std::shared_ptr<const Envelope> envelope;
};

// What can be seen at once of a long text file, whose opening goes through all of it. Its length is
// that of the time column, else about that of the rows. Nothing where opening takes no time, or
// where the file cannot be opened: open_recording() says why.
std::optional<FirstLook> first_look(const std::filesystem::path& path, const OpenOptions& options,
                                    const JobControl& job);

}  // namespace vybeg
