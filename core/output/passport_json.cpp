#include "core/output/passport_json.h"

#include "core/base/number_text.h"
#include "core/output/quantity_json.h"
#include "core/output/stored_reason.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/resonator/results/resonator_parameters.h"
#include "core/resonator/results/run_parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace vybeg {
namespace {

using Json = nlohmann::ordered_json;

// The columns of a track in the file.
struct TrackColumn {
    const char* name;
    std::vector<double> RunTrack::*member;
};
constexpr std::array<TrackColumn, 8> track_columns{{
    {"time_s", &RunTrack::time_s},
    {"a_A", &RunTrack::a_A},
    {"a_B", &RunTrack::a_B},
    {"sd_a", &RunTrack::sd_a},
    {"two_theta_A_rad", &RunTrack::two_theta_A},
    {"sd_two_theta_A_rad", &RunTrack::sd_two_theta_A},
    {"f_hz", &RunTrack::f_hz},
    {"sd_f_hz", &RunTrack::sd_f_hz},
}};

Json written(const Estimate& estimate) {
    Json json = quantity_json(estimate);
    if (!estimate.given()) {
        json["code"] = reason_name(estimate.reason.code);
        json["args"] = Json::array();
        for (const MessageArg& arg : estimate.reason.args) {
            json["args"].push_back(english(arg));
        }
    }
    return json;
}

// The following functions throw std::runtime_error, or the exception of the JSON library, with the
// reason.

[[noreturn]] void fail(const std::string& reason) {
    throw std::runtime_error(reason);
}

double number_of(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::vector<double> numbers(const Json& json) {
    std::vector<double> values;
    for (const Json& value : json) {
        values.push_back(number_of(value));
    }
    return values;
}

Reason known_reason(const std::string& name, const std::vector<std::string>& args) {
    std::optional<Reason> reason = stored_reason(name, args);
    if (!reason) {
        fail("the reason \"" + name + "\" is not known");
    }
    return std::move(*reason);
}

// Nearest present reason for reasons of schema 1 that were removed or have other arguments now.
Reason old_reason(const std::string& name, const std::vector<std::string>& args) {
    constexpr std::array<std::pair<const char*, ReasonCode>, 7> nearest{{
        {"below-noise", ReasonCode::modes_not_apart},
        {"kappa-still-wave", ReasonCode::as_given},
        {"kappa-not-seen", ReasonCode::as_given},
        {"not-asked", ReasonCode::as_given},
        {"channels-one-number", ReasonCode::held},
        {"amplitude-like-drift", ReasonCode::rests_on_unseen},
        {"residual-from-elsewhere", ReasonCode::rests_on_unseen},
    }};
    for (const auto& [old, code] : nearest) {
        if (name == old) {
            return {code, {}};
        }
    }
    if (name == "no-decay" && args.size() == 2) {  // 1/tau and its deviation
        const double rate = parse_number(args[0]).value_or(0);
        const double sd = parse_number(args[1]).value_or(0);
        return {ReasonCode::no_decay, {number_arg(1 / (std::max(rate, 0.0) + 2 * sd), 3)}};
    }
    return known_reason(name, args);
}

Estimate read_estimate(const Json& json, int schema) {
    Estimate estimate;
    if (!json.at("value").is_null()) {
        estimate.value = json.at("value").get<double>();
        estimate.sd = json.at("sd").get<double>();
        if (!(estimate.sd >= 0)) {
            fail("a standard deviation is negative");
        }
        if (json.contains("u")) {
            estimate.u = json.at("u").get<double>();
            if (!(estimate.u >= 0)) {
                fail("an uncertainty is negative");
            }
        }
        return estimate;
    }
    // A value that was not finite when written has neither code nor arguments.
    if (json.contains("code")) {
        const auto name = json.at("code").get<std::string>();
        const auto args = json.at("args").get<std::vector<std::string>>();
        estimate.reason = schema == 1 ? old_reason(name, args) : known_reason(name, args);
    } else {
        estimate.reason.code = ReasonCode::too_few_windows;
    }
    return estimate;
}

template <class Owner, class Parameters>
Json written_parameters(const Owner& owner, const Parameters& parameters) {
    Json json;
    for (const auto& parameter : parameters) {
        json[parameter.name] = written(owner.*parameter.member);
    }
    return json;
}

template <class Owner, class Parameters>
Owner read_parameters(const Json& json, const Parameters& parameters, int schema) {
    Owner owner;
    for (const auto& parameter : parameters) {
        owner.*parameter.member = read_estimate(json.at(parameter.name), schema);
    }
    return owner;
}

IdentifiedInput read_input(const Json& json) {
    return {json.at("name").get<std::string>(),  json.at("sha256").get<std::string>(),
            json.at("start").get<std::string>(), json.at("seconds").get<double>(),
            json.at("rate_hz").get<double>(),    json.at("f0_hz").get<double>()};
}

RunTrack read_track(const Json& json) {
    RunTrack track;
    for (const TrackColumn& column : track_columns) {
        track.*column.member = numbers(json.at(column.name));
        if ((track.*column.member).size() != track.time_s.size()) {
            fail(std::string("the track's ") + column.name + " has another length than its times");
        }
    }
    return track;
}

ResonatorModel read_model(const std::string& name) {
    if (name != "structured" && name != "free") {
        fail("the model is \"" + name + "\"");
    }
    return name == "free" ? ResonatorModel::free : ResonatorModel::structured;
}

// Order of the modes of a file of schema 1, always by frequency; empty where their frequencies do
// not differ.
std::optional<ModeOrder> old_mode_order(const Passport& passport) {
    constexpr double needed = 5;  // deviations
    const Estimate& split = passport.resonator.split_hz;
    if (split.given() && split.value > needed * split.sd) {
        return ModeOrder::frequency;
    }
    if (passport.modes.size() == 2) {
        const Estimate& high = passport.modes[0].f_hz;
        const Estimate& low = passport.modes[1].f_hz;
        if (high.value - low.value > needed * std::hypot(high.sd, low.sd)) {
            return ModeOrder::frequency;
        }
    }
    return std::nullopt;
}

ModeOrder read_mode_order(const std::string& name) {
    if (name == mode_order_name(ModeOrder::frequency)) {
        return ModeOrder::frequency;
    }
    if (name != mode_order_name(ModeOrder::decay)) {
        fail("the modes are named by \"" + name + "\"");
    }
    return ModeOrder::decay;
}

Passport read_all(const Json& json, int schema) {
    Passport passport;
    passport.program = json.at("program").get<std::string>();
    // Optional: files of before have none of these.
    passport.gyro = json.value("gyro", std::string());
    passport.date = json.value("date", std::string());
    if (json.contains("conditions")) {
        for (const auto& [name, value] : json.at("conditions").items()) {
            passport.conditions.emplace_back(name, value.get<std::string>());
        }
    }
    for (const Json& input : json.at("inputs")) {
        passport.inputs.push_back(read_input(input));
    }
    for (const auto& [name, value] : json.at("settings").items()) {
        passport.settings.emplace_back(name, value.get<std::string>());
    }
    passport.model = read_model(json.at("model").get<std::string>());
    passport.resonator =
        read_parameters<ResonatorEstimate>(json.at("resonator"), resonator_parameters, schema);
    for (const Json& mode : json.at("modes")) {
        passport.modes.push_back(read_parameters<ModeEstimate>(mode, mode_parameters, schema));
    }
    if (schema == 1) {
        passport.mode_order = old_mode_order(passport);
    } else {
        const Json& by = json.at("modes_by");
        passport.mode_order =
            by.is_null() ? std::nullopt : std::optional(read_mode_order(by.get<std::string>()));
        for (const Json& run : json.at("runs")) {
            passport.runs.push_back(read_parameters<RunEstimate>(run, run_parameters, schema));
        }
    }
    const Json& parameters = json.at("parameters");
    passport.raw.names = parameters.at("names").get<std::vector<std::string>>();
    passport.raw.values = numbers(parameters.at("values"));
    passport.raw.covariance = numbers(parameters.at("covariance"));
    const std::size_t count = passport.raw.names.size();
    if (passport.raw.values.size() != count || passport.raw.covariance.size() != count * count) {
        fail("parameters and covariance differ in size");
    }
    for (const Json& track : json.at("tracks")) {
        passport.tracks.push_back(read_track(track));
    }
    return passport;
}

}  // namespace

std::string passport_json(const Passport& passport) {
    Json inputs = Json::array();
    for (const IdentifiedInput& input : passport.inputs) {
        inputs.push_back({{"name", input.name},
                          {"sha256", input.sha256},
                          {"start", input.start},
                          {"seconds", input.seconds},
                          {"rate_hz", input.rate_hz},
                          {"f0_hz", input.f0_hz}});
    }
    Json settings = Json::object();
    for (const auto& [name, value] : passport.settings) {
        settings[name] = value;
    }
    Json modes = Json::array();
    for (const ModeEstimate& mode : passport.modes) {
        modes.push_back(written_parameters(mode, mode_parameters));
    }
    Json runs = Json::array();
    for (const RunEstimate& run : passport.runs) {
        runs.push_back(written_parameters(run, run_parameters));
    }
    Json tracks = Json::array();
    for (const RunTrack& track : passport.tracks) {
        Json columns;
        for (const TrackColumn& column : track_columns) {
            columns[column.name] = numbers_json(track.*column.member);
        }
        tracks.push_back(columns);
    }
    Json conditions = Json::object();
    for (const auto& [name, value] : passport.conditions) {
        conditions[name] = value;
    }
    return json_text({{"vybeg", "passport"},
                      {"schema", Passport::schema},
                      {"program", passport.program},
                      {"gyro", passport.gyro},
                      {"date", passport.date},
                      {"conditions", conditions},
                      {"inputs", inputs},
                      {"settings", settings},
                      {"model", passport.model == ResonatorModel::free ? "free" : "structured"},
                      {"resonator", written_parameters(passport.resonator, resonator_parameters)},
                      {"modes", modes},
                      {"modes_by", passport.mode_order ? Json(mode_order_name(*passport.mode_order))
                                                       : Json(nullptr)},
                      {"runs", runs},
                      {"parameters",
                       {{"names", passport.raw.names},
                        {"values", numbers_json(passport.raw.values)},
                        {"covariance", numbers_json(passport.raw.covariance)}}},
                      {"tracks", tracks}});
}

Result<Passport> read_passport(std::string_view text, const std::string& where) {
    try {
        const Json json = Json::parse(text);
        if (!json.is_object() || json.value("vybeg", Json()) != "passport") {
            return Error{ErrorCode::passport_damaged,
                         where,
                         {words(VYBEG_MESSAGE("Words", "its JSON is not a passport's"))}};
        }
        const int schema = json.at("schema").get<int>();
        if (schema < 1) {
            fail("its schema is " + std::to_string(schema));
        }
        if (schema > Passport::schema) {
            return Error{ErrorCode::passport_schema,
                         where,
                         {count_arg(schema), count_arg(Passport::schema)}};
        }
        return read_all(json, schema);
    } catch (const Json::parse_error& error) {
        return Error{ErrorCode::passport_damaged,
                     where,
                     {words(VYBEG_MESSAGE("Words", "it is no JSON at byte %1"),
                            {count_arg(static_cast<std::int64_t>(error.byte))})}};
    } catch (const std::exception& error) {
        // The JSON library prefixes its name of the error in brackets.
        const std::string reason = error.what();
        const std::size_t bracket = reason.starts_with('[') ? reason.find("] ") : std::string::npos;
        return Error{ErrorCode::passport_damaged,
                     where,
                     {bracket == std::string::npos ? reason : reason.substr(bracket + 2)}};
    }
}

Result<Passport> read_passport_file(const std::filesystem::path& path) {
    const Result<std::string> text = own_file_text(path);
    return text ? read_passport(*text, path.string()) : text.error();
}

}  // namespace vybeg
