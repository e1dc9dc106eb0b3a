#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/measurement_list.h"
#include "core/base/finding.h"
#include "core/resonator/results/passport.h"

#include <span>
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

// Comparison of a set with a passport.
struct PassportComparison {
    std::string file;
    std::string sha256;
    std::string program;
    std::vector<Difference> differences;
};

// Result of `identify` as JSON, with the drift function and the channel balance; `comparison` adds
// `passport` and `differences`, null: none. `inputs` as identification.runs.
std::string identify_json(const std::string& program, std::span<const IdentifiedInput> inputs,
                          const Identification& identification,
                          const PassportComparison* comparison);

// The passport of an identification; gyro, date and conditions are those of the set.
Passport passport_of(const std::string& program, std::span<const IdentifiedInput> inputs,
                     const Identification& identification, const MeasurementSet& set);

}  // namespace vybeg
