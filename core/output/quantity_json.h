#pragma once

#include "core/analysis/measurement_list.h"
#include "core/base/diagnostic.h"
#include "core/base/setting_rows.h"
#include "core/resonator/model/reason.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

using Json = nlohmann::ordered_json;

// Numbers in JSON, where NaN does not exist.

// What `json_of` makes of each value.
template <class Values, class JsonOf>
Json list_json(const Values& values, const JsonOf& json_of) {
    Json list = Json::array();
    for (const auto& value : values) {
        list.push_back(Json(json_of(value)));
    }
    return list;
}

// The number, or null where it is not finite.
Json number_json(double value);
Json numbers_json(std::span<const double> values);

// Names and values, settings among them, as an object.
Json named_json(std::span<const NamedValue> values);

// A quantity as JSON: {"value": x, "sd": s} or {"value": null, "reason": "..."}; with "u" where
// tolerances contribute.
Json quantity_json(const Estimate& estimate);

// The quantities of an owner, or of each of several, by a table of its members with their names.
template <class Owner, class Parameters>
Json parameters_json(const Owner& owner, const Parameters& parameters,
                     Json (*json_of)(const Estimate&) = quantity_json) {
    Json object;
    for (const auto& parameter : parameters) {
        object[parameter.name] = json_of(owner.*parameter.member);
    }
    return object;
}
template <class Owner, class Parameters>
Json parameters_json(const std::vector<Owner>& owners, const Parameters& parameters,
                     Json (*json_of)(const Estimate&) = quantity_json) {
    return list_json(
        owners, [&](const Owner& owner) { return parameters_json(owner, parameters, json_of); });
}

// The recordings of a set: names and what they contain.
Json inputs_json(std::span<const RecordingRef> inputs);

// Arguments of a message, in English.
Json args_json(std::span<const MessageArg> args);

// A line of a list of warnings.
Json finding_json(const Finding& finding);

// The JSON as text, indented, with a line feed at its end. Invalid UTF-8 in names from files is
// replaced.
std::string json_text(const Json& json);

// The same on one line, without a line feed.
std::string json_line(const Json& json);

// The reason with this name in JSON (reason_name()) and these arguments, as they read in English;
// nothing: this version knows no such reason.
std::optional<Reason> stored_reason(const std::string& name, const std::vector<std::string>& args);

// The same for a diagnostic and kind_name().
std::optional<Diagnostic> stored_diagnostic(const std::string& name,
                                            const std::vector<std::string>& args);

}  // namespace vybeg
