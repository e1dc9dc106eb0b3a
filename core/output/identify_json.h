#pragma once

#include "core/analysis/set_result.h"
#include "core/base/finding.h"

#include <string>
#include <vector>

namespace vybeg {

// A warning of an identification and its recording.
struct IdentifyWarning {
    Diagnostic diagnostic;
    int input = -1;  // index of the recording; -1: the fit
};

// Warnings of the recordings in their order, then those of the fit.
std::vector<IdentifyWarning> all_warnings(const Identification& identification);

// The same, each kind once, the worst first: of the result, then of the recordings.
std::vector<Finding> findings_of(const Identification& identification);

// Result of `identify` as JSON, with the drift function and the channel balance; a comparison adds
// `passport` and `differences`.
std::string identify_json(const SetResult& result);

// The passport of a result; gyro, date and conditions are those of the set.
Passport passport_of(const SetResult& result);

}  // namespace vybeg
