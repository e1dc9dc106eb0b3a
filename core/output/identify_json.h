#pragma once

#include "core/analysis/passport.h"
#include "core/base/diagnostic.h"
#include "core/recording/samples/recording.h"

#include <span>
#include <string>
#include <vector>

namespace vybeg {

// Warnings of the result, then of its recordings, each kind once, the worst first.
std::vector<Finding> findings_of(const Identification& identification);

// Result of `identify` as JSON, with the drift function and the channel balance; a comparison adds
// `passport` and `differences`.
std::string identify_json(const SetResult& result);

// The passport of a result; gyro, date and conditions are those of the set.
Passport passport_of(const SetResult& result);

// Output of `info --json`, indented, with a final line feed. `findings`: those of the recording
// check.
std::string recording_json(const Recording& recording, const std::string& sha256,
                           std::span<const Diagnostic> findings);

}  // namespace vybeg
