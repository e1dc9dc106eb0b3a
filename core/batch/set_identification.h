#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/measurement_list.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/batch/batch_events.h"
#include "core/output/identify_json.h"
#include "core/recording/samples/recording.h"
#include "core/resonator/results/passport.h"

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace vybeg {

// From the files of one set to its resonator: the work that identify, compare and batch share.

// The recordings of a set, and the passport that it is compared with.
struct OpenSet {
    std::vector<Recording> recordings;
    std::vector<IdentifiedInput> told;
    std::optional<Passport> passport;
    std::optional<PassportComparison> comparison;
};

// `passport`: empty, there is none. Errors: conditions_differ, those of open_recording() and
// read_passport_file(), same_recording.
Result<OpenSet> open_set(const MeasurementSet& set, const std::string& passport,
                         std::stop_token stop);

struct IdentifiedSet {
    Identification found;
    std::vector<NamedWarnings> warnings;
};

// Adds what is found to `open`. Errors: those of identify(), file_changed.
Result<IdentifiedSet> identify_set(OpenSet& open, const MeasurementSet& set,
                                   const CompareOptions& compare, const JobControl& job);

// Of the recordings alone.
std::vector<NamedWarnings> warnings_of(const OpenSet& open);

}  // namespace vybeg
