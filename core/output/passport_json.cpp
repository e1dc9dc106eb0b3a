#include "core/output/passport_json.h"

#include "core/output/identify_json.h"
#include "core/output/quantity_json.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/resonator/results/resonator_parameters.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

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
        json["args"] = args_json(estimate.reason.args);
    }
    return json;
}

// The fault of a passport, thrown by the following functions without its place.
Error fault(MessageArg reason) {
    return {ErrorCode::passport_damaged, {}, {std::move(reason)}};
}

// A value of the file with its place, as "resonator.tau_s.value" or "runs[1].a_A".
class Node {
public:
    Node(const Json& json, std::string place) : json_(json), place_(std::move(place)) {}

    bool is_null() const { return json_.is_null(); }
    bool has(const char* key) const { return json_.is_object() && json_.contains(key); }

    Node at(const char* key) const {
        if (!json_.is_object()) {
            wrong(VYBEG_MESSAGE("Words", "an object"));
        }
        const auto found = json_.find(key);
        const std::string place = place_.empty() ? key : place_ + '.' + key;
        if (found == json_.end()) {
            throw fault(Phrase::tr("%1 is missing", {place}));
        }
        return {*found, place};
    }

    std::vector<Node> elements() const {
        if (!json_.is_array()) {
            wrong(VYBEG_MESSAGE("Words", "a list"));
        }
        std::vector<Node> nodes;
        for (const Json& element : json_) {
            nodes.emplace_back(element, place_ + '[' + std::to_string(nodes.size()) + ']');
        }
        return nodes;
    }

    // What `read` makes of each element.
    template <class Read>
    auto list(const Read& read) const {
        std::vector<std::invoke_result_t<Read, const Node&>> all;
        std::ranges::transform(elements(), std::back_inserter(all), read);
        return all;
    }

    // Values by their names, all of them texts.
    std::vector<std::pair<std::string, std::string>> texts_by_name() const {
        if (!json_.is_object()) {
            wrong(VYBEG_MESSAGE("Words", "an object"));
        }
        std::vector<std::pair<std::string, std::string>> texts;
        for (const auto& [name, value] : json_.items()) {
            texts.emplace_back(name, Node(value, place_ + '.' + name).text());
        }
        return texts;
    }

    std::string text() const {
        if (!json_.is_string()) {
            wrong(VYBEG_MESSAGE("Words", "a text"));
        }
        return json_.get<std::string>();
    }

    std::vector<std::string> texts() const { return list(&Node::text); }

    int whole_number() const {
        if (!json_.is_number_integer()) {
            wrong(VYBEG_MESSAGE("Words", "a whole number"));
        }
        return json_.get<int>();
    }

    double number() const {
        if (!json_.is_number()) {
            wrong(VYBEG_MESSAGE("Words", "a number"));
        }
        return json_.get<double>();
    }

    double positive_or_zero() const {
        if (!(number() >= 0)) {
            wrong(VYBEG_MESSAGE("Words", "a number that is not negative"));
        }
        return number();
    }

    // Numbers that are not finite are null.
    double number_or_nan() const {
        return is_null() ? std::numeric_limits<double>::quiet_NaN() : number();
    }

    std::vector<double> numbers() const { return list(&Node::number_or_nan); }

    // `expected`: the kind of value that has to be here.
    [[noreturn]] void wrong(const char* expected) const {
        throw fault(
            Phrase::tr("%1: %2 is expected, and %3 is there", {place_, words(expected), found()}));
    }

private:
    MessageArg found() const {
        if (json_.is_object()) {
            return Phrase::tr("an object");
        }
        if (json_.is_array()) {
            return Phrase::tr("a list");
        }
        return short_quote(json_line(json_));
    }

    const Json& json_;
    std::string place_;
};

Reason known_reason(const Node& name, const std::vector<std::string>& args) {
    std::optional<Reason> reason = stored_reason(name.text(), args);
    if (!reason) {
        name.wrong(VYBEG_MESSAGE("Words", "a reason known here"));
    }
    return std::move(*reason);
}

Estimate read_estimate(const Node& json) {
    Estimate estimate;
    if (!json.at("value").is_null()) {
        estimate.value = json.at("value").number();
        estimate.sd = json.at("sd").positive_or_zero();
        if (json.has("u")) {
            estimate.u = json.at("u").positive_or_zero();
        }
        return estimate;
    }
    // A value that was not finite when written has neither code nor arguments.
    if (json.has("code")) {
        estimate.reason = known_reason(json.at("code"), json.at("args").texts());
    } else {
        estimate.reason.code = ReasonCode::too_few_windows;
    }
    return estimate;
}

// Reads the owner of these parameters.
template <class Owner, class Parameters>
auto reader_of(const Parameters& parameters) {
    return [&parameters](const Node& json) {
        Owner owner;
        for (const auto& parameter : parameters) {
            owner.*parameter.member = read_estimate(json.at(parameter.name));
        }
        return owner;
    };
}

RecordingRef read_input(const Node& json) {
    const std::string name = json.at("name").text();
    return {.file = name,
            .path = name,
            .sha256 = json.at("sha256").text(),
            .start = json.at("start").text(),
            .seconds = json.at("seconds").number(),
            .rate_hz = json.at("rate_hz").number(),
            .f0_hz = json.at("f0_hz").number_or_nan()};
}

RunTrack read_track(const Node& json) {
    RunTrack track;
    for (const TrackColumn& column : track_columns) {
        const Node values = json.at(column.name);
        track.*column.member = values.numbers();
        if ((track.*column.member).size() != track.time_s.size()) {
            values.wrong(VYBEG_MESSAGE("Words", "a list as long as that of the times"));
        }
    }
    return track;
}

ResonatorModel read_model(const Node& name) {
    if (name.text() != "structured" && name.text() != "free") {
        name.wrong(VYBEG_MESSAGE("Words", "structured or free"));
    }
    return name.text() == "free" ? ResonatorModel::free : ResonatorModel::structured;
}

ModeOrder read_mode_order(const Node& name) {
    for (const ModeOrder order : {ModeOrder::frequency, ModeOrder::decay}) {
        if (name.text() == mode_order_name(order)) {
            return order;
        }
    }
    name.wrong(VYBEG_MESSAGE("Words", "an order of the modes"));
}

Passport read_any(const Node& json) {
    const Node schema = json.at("schema");
    if (schema.whole_number() < 1) {
        schema.wrong(VYBEG_MESSAGE("Words", "a positive number"));
    }
    if (schema.whole_number() > Passport::schema) {
        throw Error{ErrorCode::passport_schema,
                    {},
                    {count_arg(schema.whole_number()), count_arg(Passport::schema)}};
    }
    if (schema.whole_number() < Passport::schema) {
        throw fault(
            Phrase::tr("its schema %1 is that of an early version, which is read no longer: "
                       "identify its recordings again",
                       {count_arg(schema.whole_number())}));
    }
    Passport passport;
    passport.program = json.at("program").text();
    // Optional: files of before have none of these.
    passport.gyro = json.has("gyro") ? json.at("gyro").text() : "";
    passport.date = json.has("date") ? json.at("date").text() : "";
    if (json.has("conditions")) {
        passport.conditions = json.at("conditions").texts_by_name();
    }
    passport.inputs = json.at("inputs").list(read_input);
    passport.settings = json.at("settings").texts_by_name();
    passport.model = read_model(json.at("model"));
    passport.resonator = reader_of<ResonatorEstimate>(resonator_parameters)(json.at("resonator"));
    passport.modes = json.at("modes").list(reader_of<ModeEstimate>(mode_parameters));
    passport.mode_order = read_mode_order(json.at("modes_by"));
    passport.runs = json.at("runs").list(reader_of<RunEstimate>(run_parameters));
    const Node parameters = json.at("parameters");
    passport.raw.names = parameters.at("names").texts();
    passport.raw.values = parameters.at("values").numbers();
    passport.raw.covariance = parameters.at("covariance").numbers();
    const std::size_t count = passport.raw.names.size();
    if (passport.raw.values.size() != count) {
        parameters.at("values").wrong(
            VYBEG_MESSAGE("Words", "a list as long as that of the names"));
    }
    if (passport.raw.covariance.size() != count * count) {
        parameters.at("covariance")
            .wrong(VYBEG_MESSAGE("Words", "a list of a number for each two names"));
    }
    passport.tracks = json.at("tracks").list(read_track);
    return passport;
}

Json passport_object(const Passport& passport) {
    const auto columns_of = [](const RunTrack& track) {
        Json columns;
        for (const TrackColumn& column : track_columns) {
            columns[column.name] = numbers_json(track.*column.member);
        }
        return columns;
    };
    return {{"vybeg", "passport"},
            {"schema", Passport::schema},
            {"program", passport.program},
            {"gyro", passport.gyro},
            {"date", passport.date},
            {"conditions", named_json(passport.conditions)},
            {"inputs", inputs_json(passport.inputs)},
            {"settings", named_json(passport.settings)},
            {"model", passport.model == ResonatorModel::free ? "free" : "structured"},
            {"resonator", parameters_json(passport.resonator, resonator_parameters, written)},
            {"modes", parameters_json(passport.modes, mode_parameters, written)},
            {"modes_by", mode_order_name(passport.mode_order)},
            {"runs", parameters_json(passport.runs, run_parameters, written)},
            {"parameters",
             {{"names", passport.raw.names},
              {"values", numbers_json(passport.raw.values)},
              {"covariance", numbers_json(passport.raw.covariance)}}},
            {"tracks", list_json(passport.tracks, columns_of)}};
}

// What `read` makes of a text.
template <class Read>
auto reading(std::string_view text, const std::string& where, const Read& read)
    -> Result<decltype(read(Json()))> {
    Error error;
    try {
        return read(Json::parse(text));
    } catch (const Json::parse_error& parsed) {
        error = fault(Phrase::tr("it is no JSON at byte %1",
                                 {count_arg(static_cast<std::int64_t>(parsed.byte))}));
    } catch (const Json::exception&) {
        error = fault(Phrase::tr("it holds a number beyond all ranges"));
    } catch (const Error& thrown) {
        error = thrown;
    }
    error.where = where;
    return error;
}

// `input`: index of the recording that it concerns; -1: the fit.
Json warning_json(const Diagnostic& warning, int input) {
    return {{"kind", kind_name(warning.kind)}, {"args", args_json(warning.args)}, {"input", input}};
}

Json run_json(const IdentifiedRun& run) {
    return {{"window", run.window},
            {"windows", run.windows},
            {"windows_used", run.windows_used},
            {"noise_sd", number_json(run.noise_sd)}};
}

IdentifiedRun read_run(const Node& json) {
    IdentifiedRun run;
    run.window = json.at("window").whole_number();
    run.windows = json.at("windows").whole_number();
    run.windows_used = json.at("windows_used").whole_number();
    run.noise_sd = json.at("noise_sd").number_or_nan();
    return run;
}

// A warning of a later version, whose words are not known here, is left out.
void read_warning(const Node& json, Identification& identification) {
    const auto warning = stored_diagnostic(json.at("kind").text(), json.at("args").texts());
    const int input = json.at("input").whole_number();
    if (!warning || input >= static_cast<int>(identification.runs.size())) {
        return;
    }
    auto& list = input < 0 ? identification.fit.warnings
                           : identification.runs[static_cast<std::size_t>(input)].diagnostics;
    list.push_back(*warning);
}

SetResult read_saved(const Node& whole) {
    Passport passport = read_any(whole.at("passport"));
    SetResult result;
    result.program = std::move(passport.program);
    result.set.recordings = std::move(passport.inputs);
    ResonatorFit& fit = result.identification.fit;
    static_cast<ResonatorNumbers&>(fit) = std::move(passport);
    const Node no_modes = whole.at("no_modes");
    fit.no_modes =
        stored_reason(no_modes.at("kind").text(), no_modes.at("args").texts()).value_or(Reason{});
    fit.chi2_per_dof = whole.at("chi2_per_dof").number_or_nan();
    result.identification.runs = whole.at("runs").list(read_run);
    const std::size_t count = result.set.recordings.size();
    fit.runs.resize(count);
    result.identification.runs.resize(count);
    for (const Node& warning : whole.at("warnings").elements()) {
        read_warning(warning, result.identification);
    }
    return result;
}

}  // namespace

std::string passport_json(const Passport& passport) {
    return json_text(passport_object(passport));
}

Result<Passport> read_passport(std::string_view text, const std::string& where) {
    return reading(text, where, [](const Json& json) {
        if (json.is_object() && !json.contains("vybeg") && json.contains("modes_by")) {
            throw fault(Phrase::tr("it is a result of identify; --passport writes the passport"));
        }
        if (!json.is_object() || json.value("vybeg", Json()) != "passport") {
            throw fault(Phrase::tr("its JSON is not a passport's"));
        }
        return read_any(Node(json, ""));
    });
}

Result<Passport> read_passport_file(const std::filesystem::path& path) {
    const Result<std::string> text = own_file_text(path);
    return text ? read_passport(*text, path.string()) : text.error();
}

std::string saved_result_json(const SetResult& result) {
    Passport passport = passport_of(result);
    for (RunTrack& track : passport.tracks) {
        track = {};
    }
    Json runs = Json::array();
    Json warnings = Json::array();
    for (const IdentifiedRun& run : result.identification.runs) {
        for (const Diagnostic& warning : run.diagnostics) {
            warnings.push_back(warning_json(warning, static_cast<int>(runs.size())));
        }
        runs.push_back(run_json(run));
    }
    const ResonatorFit& fit = result.identification.fit;
    for (const Diagnostic& warning : fit.warnings) {
        warnings.push_back(warning_json(warning, -1));
    }
    return json_text(
        {{"passport", passport_object(passport)},
         {"no_modes",
          {{"kind", reason_name(fit.no_modes.code)}, {"args", args_json(fit.no_modes.args)}}},
         {"chi2_per_dof", number_json(fit.chi2_per_dof)},
         {"runs", runs},
         {"warnings", warnings}});
}

Result<SetResult> read_saved_result(std::string_view text) {
    return reading(text, {}, [](const Json& json) { return read_saved(Node(json, "")); });
}

}  // namespace vybeg
