#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/measurement_list.h"
#include "core/resonator/results/passport.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// Where the date of a result is from.
enum class DateSource { none, list, recording };

// The date of a result, ISO 8601; empty: neither the list nor a recording tells one.
struct StoredDate {
    std::string text;
    DateSource source = DateSource::none;

    friend bool operator==(const StoredDate&, const StoredDate&) = default;
};

// A recording of a result, with its conditions.
struct StoredRecording {
    std::string file;  // as the list names it
    std::string path;  // absolute, where it was read
    IdentifiedInput input;
    OpenOptions open;
    Conditions conditions;
    std::vector<std::pair<std::string, std::string>> others;  // the list's unknown columns
};

// A parameter by its name in identify JSON: those of resonator_parameters.h, and of each mode
// "modes[0].f_hz", ...
struct StoredParameter {
    std::string name;
    Estimate estimate;
};

// The result of one set as the database keeps it.
struct StoredResult {
    std::string key;   // what makes it the same result: SHA-256 of its recordings and settings
    std::string set;   // name in its list
    std::string gyro;  // empty: not told
    StoredDate date;
    std::string program;   // name and version
    std::string model;     // "structured" or "free"
    std::string warnings;  // warning_kinds()
    std::vector<StoredRecording> recordings;
    std::vector<StoredParameter> parameters;
    RawParameters raw;
    std::string json;  // as identify writes it
};

// An identified set as it is to be stored. `other_columns` as the list's, `inputs` as the set's
// recordings, `json` of identify_json(). The key depends on the content of the recordings, on the
// channels, options and settings with which each was read, and on the settings of the fit, not on
// names, conditions, threads, the program's version or the order of the recordings. Precondition:
// `found` is of this set. Errors: those of text_sha256().
Result<StoredResult> stored_result(const std::string& program, const MeasurementSet& set,
                                   std::span<const std::string> other_columns,
                                   std::span<const IdentifiedInput> inputs,
                                   const Identification& found, std::string json);

}  // namespace vybeg
