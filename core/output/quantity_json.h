#pragma once

#include "core/analysis/measurement_list.h"
#include "core/base/finding.h"
#include "core/base/setting_rows.h"
#include "core/resonator/model/reason.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>

namespace vybeg {

// Numbers in JSON, where NaN does not exist.

// The number, or null where it is not finite.
nlohmann::ordered_json number_json(double value);
nlohmann::ordered_json numbers_json(std::span<const double> values);

// Names and values, settings among them, as an object.
nlohmann::ordered_json named_json(std::span<const NamedValue> values);

// A quantity as JSON: {"value": x, "sd": s} or {"value": null, "reason": "..."}; with "u" where
// tolerances contribute.
nlohmann::ordered_json quantity_json(const Estimate& estimate);

// The recordings of a set: names and what they contain.
nlohmann::ordered_json inputs_json(std::span<const RecordingRef> inputs);

// Arguments of a message, in English.
nlohmann::ordered_json args_json(std::span<const MessageArg> args);

// A line of a list of warnings.
nlohmann::ordered_json finding_json(const Finding& finding);

// The JSON as text, indented, with a line feed at its end. Invalid UTF-8 in names from files is
// replaced.
std::string json_text(const nlohmann::ordered_json& json);

// The same on one line, without a line feed.
std::string json_line(const nlohmann::ordered_json& json);

}  // namespace vybeg
