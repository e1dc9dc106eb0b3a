#pragma once

#include "core/recording/samples/recording.h"

#include <span>
#include <string>

namespace vybeg {

// Output of `info --json`, indented, with a final line feed. `findings`: those of the recording
// check.
std::string recording_json(const Recording& recording, const std::string& sha256,
                           std::span<const Diagnostic> findings);

}  // namespace vybeg
