#pragma once

#include "core/recording/recording.h"

#include <string>

namespace vybeg {

// What `info --json` prints: INTERFACE.md, section vybeg-cli. Indented, ends with a line feed.
std::string recording_json(const Recording& recording, const std::string& sha256);

}  // namespace vybeg
