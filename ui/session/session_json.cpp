#include "ui/session/session_json.h"

#include "core/analysis/setting_table.h"
#include "ui/import/open_options_json.h"
#include "ui/session/listed_json.h"
#include "ui/values/setting_json.h"
#include "ui/words/program_name.h"

#include <QJsonArray>

#include <algorithm>
#include <utility>

namespace vybeg::ui {

namespace {

const QString schema_key = QStringLiteral("vybeg_session");
const QString program_key = QStringLiteral("program");
const QString settings_key = QStringLiteral("settings");
const QString tolerance_key = QStringLiteral("tolerance");
const QString live_key = QStringLiteral("live");
const QString recordings_key = QStringLiteral("recordings");
const QString current_key = QStringLiteral("current");
const QString sets_key = QStringLiteral("sets");
const QString current_set_key = QStringLiteral("current_set");
const QString current_run_key = QStringLiteral("current_run");
const QString listed_key = QStringLiteral("listed");
const QString result_key = QStringLiteral("result");
const QString up_to_date_key = QStringLiteral("result_up_to_date");
const QString view_key = QStringLiteral("view");
const QString gyro_key = QStringLiteral("gyro");
const QString limits_key = QStringLiteral("limits");
const QString serial_key = QStringLiteral("serial");
const QString type_key = QStringLiteral("type");
const QString operator_key = QStringLiteral("operator");
const QString comment_key = QStringLiteral("comment");
const QString page_key = QStringLiteral("page");
const QString trend_key = QStringLiteral("trend");

// As TrendKind.
constexpr std::array<QLatin1String, trend_kinds> trend_words{
    QLatin1String("line"), QLatin1String("parabola"), QLatin1String("cubic"),
    QLatin1String("beat")};

QString text(const std::string& utf8) {
    return QString::fromStdString(utf8);
}

Result<Settings> analysisFromJson(const QJsonObject& json) {
    Result<Settings> settings = settingsFromJson(analysis_settings(), json);
    if (settings) {
        if (const Status valid = validate(*settings); !valid) {
            return valid.error();
        }
    }
    return settings;
}

// One field of an identification, by the name of its row.
const SettingRow<IdentifySettings>& identifyRow(const std::string& name) {
    return *std::ranges::find(identify_settings(), name, &SettingRow<IdentifySettings>::name);
}

QJsonObject runToJson(const RunWish& run) {
    return {{QStringLiteral("name"), run.name},
            {QStringLiteral("place"), run.place},
            {QStringLiteral("color"), run.color.name()},
            {QStringLiteral("dash"), static_cast<int>(run.dash)},
            {QStringLiteral("visible"), run.visible},
            {QStringLiteral("live"), run.live},
            {settings_key, settingsToJson(analysis_settings(), run.settings)}};
}

Result<RunWish> runFromJson(const QJsonObject& json) {
    const Result<Settings> settings = analysisFromJson(json[settings_key].toObject());
    if (!settings) {
        return settings.error();
    }
    RunWish run;
    run.settings = *settings;
    run.name = json[QStringLiteral("name")].toString();
    run.place = json[QStringLiteral("place")].toInt();
    run.color = QColor(json[QStringLiteral("color")].toString());
    run.dash =
        static_cast<Qt::PenStyle>(std::clamp(json[QStringLiteral("dash")].toInt(Qt::SolidLine),
                                             int{Qt::SolidLine}, int{Qt::DashDotDotLine}));
    run.visible = json[QStringLiteral("visible")].toBool(true);
    run.live = json[live_key].toBool();
    return run;
}

QJsonObject recordingToJson(const SessionRecording& recording, const QDir& folder) {
    QJsonArray runs;
    for (const RunWish& run : recording.runs) {
        runs.append(runToJson(run));
    }
    return {{QStringLiteral("path"), storedPath(recording.path, folder)},
            {QStringLiteral("sha256"), recording.sha256},
            {QStringLiteral("options"), optionsToJson(recording.options)},
            {QStringLiteral("runs"), runs}};
}

Result<SessionRecording> recordingFromJson(const QJsonObject& json, const QDir& folder) {
    SessionRecording recording;
    recording.path =
        QDir::cleanPath(folder.absoluteFilePath(json[QStringLiteral("path")].toString()));
    recording.sha256 = json[QStringLiteral("sha256")].toString();
    recording.options = optionsFromJson(json[QStringLiteral("options")].toObject());
    for (const auto& value : json[QStringLiteral("runs")].toArray()) {
        Result<RunWish> run = runFromJson(value.toObject());
        if (!run) {
            return run.error();
        }
        recording.runs.push_back(std::move(*run));
    }
    return recording;
}

QJsonObject setToJson(const SessionSet& set, const QDir& folder) {
    QJsonArray members;
    for (const int place : set.recordings) {
        members.append(place);
    }
    IdentifySettings model;
    model.model = set.model;
    QJsonObject json{{QStringLiteral("name"), set.name},
                     {QStringLiteral("model"), text(identifyRow("model").text(model))},
                     {recordings_key, members}};
    if (set.listed) {
        json[listed_key] = listedToJson(*set.listed, folder);
    }
    if (!set.result.json.isEmpty()) {
        json[result_key] = set.result.json;
        json[up_to_date_key] = set.result.up_to_date;
    }
    return json;
}

Result<SessionSet> setFromJson(const QJsonObject& json, int recordings, const QDir& folder) {
    SessionSet set;
    set.name = json[QStringLiteral("name")].toString();
    for (const auto& value : json[recordings_key].toArray()) {
        if (const int place = value.toInt(-1); place >= 0 && place < recordings) {
            set.recordings.push_back(place);
        }
    }
    IdentifySettings model;
    if (const QString word = json[QStringLiteral("model")].toString(); !word.isEmpty()) {
        if (const Status read = identifyRow("model").read(word.toStdString(), model); !read) {
            return read.error();
        }
    }
    set.model = model.model;
    if (const QJsonValue listed = json[listed_key]; listed.isObject()) {
        Result<ListedSet> read = listedFromJson(listed.toObject(), folder);
        if (!read) {
            return read.error();
        }
        set.listed = std::move(*read);
    }
    set.result = {json[result_key].toObject(), json[up_to_date_key].toBool()};
    return set;
}

// Keys of a later version stay in the gyro's object of the unknown keys.
QJsonObject gyroToJson(const GyroData& gyro, QJsonObject json) {
    json[serial_key] = gyro.serial;
    json[type_key] = gyro.type;
    json[operator_key] = gyro.operator_name;
    json[comment_key] = gyro.comment;
    return json;
}

GyroData gyroFromJson(const QJsonObject& json) {
    return {json[serial_key].toString(), json[type_key].toString(), json[operator_key].toString(),
            json[comment_key].toString()};
}

// By parameter the least and the greatest value in stored units, null for none.
QJsonObject limitsToJson(const std::vector<ParameterLimit>& limits) {
    const auto end = [](const std::optional<double>& value) {
        return value ? QJsonValue(*value) : QJsonValue();
    };
    QJsonObject json;
    for (const ParameterLimit& limit : limits) {
        json[text(limit.parameter)] = QJsonArray{end(limit.lower), end(limit.upper)};
    }
    return json;
}

std::vector<ParameterLimit> limitsFromJson(const QJsonObject& json) {
    std::vector<ParameterLimit> limits;
    for (const ResonatorParameter& parameter : limited_parameters()) {
        const QJsonArray ends = json[QLatin1String(parameter.name)].toArray();
        const auto end = [&ends](int which) {
            return ends.at(which).isDouble() ? std::optional(ends.at(which).toDouble())
                                             : std::nullopt;
        };
        if (end(0) || end(1)) {
            limits.push_back({parameter.name, end(0), end(1)});
        }
    }
    return limits;
}

TrendKind trendFromJson(const QJsonValue& value) {
    const auto found = std::ranges::find(trend_words, value.toString());
    return found == trend_words.end() ? TrendKind::line
                                      : static_cast<TrendKind>(found - trend_words.begin());
}

QJsonArray rangeToJson(const AxisRange& range) {
    return {range.lower, range.upper};
}

std::optional<AxisRange> rangeFromJson(const QJsonValue& value) {
    const QJsonArray ends = value.toArray();
    const AxisRange range{ends.at(0).toDouble(), ends.at(1).toDouble()};
    return range.lower < range.upper ? std::optional(range) : std::nullopt;
}

QString columnOf(SlowVariable variable) {
    return QLatin1String(info(variable).column);
}

std::optional<SlowVariable> variableOf(const QString& column) {
    const auto found = std::ranges::find(all_slow_variables, column, columnOf);
    return found == all_slow_variables.end() ? std::nullopt : std::optional(*found);
}

template <class Unit>
Unit unitFromJson(const QJsonObject& json, const char* key, Unit last) {
    const int value = json[QLatin1String(key)].toInt();
    return static_cast<Unit>(std::clamp(value, 0, static_cast<int>(last)));
}

// A place in a list, -1 for one outside of it.
int placeFromJson(const QJsonValue& value, std::size_t count) {
    const int place = value.toInt(-1);
    return place >= 0 && place < static_cast<int>(count) ? place : -1;
}

}  // namespace

QJsonObject viewToJson(const SessionView& view) {
    QJsonObject values;
    for (const auto& [variable, range] : view.zoom.fixed) {
        values[columnOf(variable)] = rangeToJson(range);
    }
    QJsonArray variables;
    for (const SlowVariable variable : view.variables) {
        variables.append(columnOf(variable));
    }
    QJsonArray cursors;
    for (const auto& cursor : view.cursors_s) {
        cursors.append(cursor ? QJsonValue(*cursor) : QJsonValue());
    }
    const DisplayUnits& units = view.units;
    return {{QStringLiteral("time_s"), rangeToJson(view.zoom.time)},
            {QStringLiteral("values"), values},
            {QStringLiteral("variables"), variables},
            {QStringLiteral("cursors_s"), cursors},
            {page_key, view.page},
            {trend_key, trend_words.at(static_cast<std::size_t>(view.trend))},
            {QStringLiteral("units"),
             QJsonObject{{QStringLiteral("frequency"), static_cast<int>(units.frequency)},
                         {QStringLiteral("angle"), static_cast<int>(units.angle)},
                         {QStringLiteral("amplitude"), static_cast<int>(units.amplitude)},
                         {QStringLiteral("volts_per_unit"), units.volts_per_unit},
                         {QStringLiteral("log_a_A"), units.log_a_A},
                         {QStringLiteral("sigma_bands"), units.sigma_bands}}}};
}

SessionView viewFromJson(const QJsonObject& json) {
    SessionView view;
    if (const auto time = rangeFromJson(json[QStringLiteral("time_s")])) {
        view.zoom.time = *time;
    }
    const QJsonObject values = json[QStringLiteral("values")].toObject();
    for (const SlowVariable variable : all_slow_variables) {
        if (const auto range = rangeFromJson(values[columnOf(variable)])) {
            view.zoom.fixed.emplace(variable, *range);
        }
    }
    for (const auto& value : json[QStringLiteral("variables")].toArray()) {
        if (const auto variable = variableOf(value.toString())) {
            view.variables.push_back(*variable);
        }
    }
    const QJsonArray cursors = json[QStringLiteral("cursors_s")].toArray();
    for (int which = 0; which < 2; ++which) {
        if (cursors.at(which).isDouble()) {
            view.cursors_s[static_cast<std::size_t>(which)] = cursors.at(which).toDouble();
        }
    }
    view.page = json[page_key].toString();
    view.trend = trendFromJson(json[trend_key]);
    const QJsonObject units = json[QStringLiteral("units")].toObject();
    view.units.frequency = unitFromJson(units, "frequency", FrequencyUnit::deviation_ppm);
    view.units.angle = unitFromJson(units, "angle", AngleUnit::degrees);
    view.units.amplitude = unitFromJson(units, "amplitude", AmplitudeUnit::decibels);
    view.units.volts_per_unit = units[QStringLiteral("volts_per_unit")].toDouble(1);
    view.units.log_a_A = units[QStringLiteral("log_a_A")].toBool();
    view.units.sigma_bands = units[QStringLiteral("sigma_bands")].toBool(true);
    return view;
}

QJsonObject sessionToJson(const Session& session, const QDir& folder) {
    IdentifySettings tolerance;
    tolerance.tolerance = session.tolerance;
    QJsonArray recordings;
    for (const SessionRecording& recording : session.recordings) {
        recordings.append(recordingToJson(recording, folder));
    }
    QJsonArray sets;
    for (const SessionSet& set : session.sets) {
        sets.append(setToJson(set, folder));
    }
    QJsonObject json = session.unknown;
    json[schema_key] = session_schema;
    json[program_key] = programName();
    json[settings_key] = settingsToJson(analysis_settings(), session.settings);
    json[tolerance_key] = text(identifyRow("tolerance").text(tolerance));
    json[live_key] = session.live;
    json[recordings_key] = recordings;
    json[current_key] = session.current;
    json[sets_key] = sets;
    json[current_set_key] = session.current_set;
    json[current_run_key] = session.current_run;
    json[gyro_key] = gyroToJson(session.dossier.gyro, json[gyro_key].toObject());
    json[limits_key] = limitsToJson(session.dossier.limits);
    json[view_key] = viewToJson(session.view);
    return json;
}

Result<Session> sessionFromJson(const QJsonObject& json, const QDir& folder) {
    Session session;
    const Result<Settings> settings = analysisFromJson(json[settings_key].toObject());
    if (!settings) {
        return settings.error();
    }
    session.settings = *settings;
    IdentifySettings tolerance;
    if (const QString stored = json[tolerance_key].toString(); !stored.isEmpty()) {
        const Status read = identifyRow("tolerance").read(stored.toStdString(), tolerance);
        if (!read) {
            return read.error();
        }
    }
    session.tolerance = tolerance.tolerance;
    session.live = json[live_key].toBool(true);
    for (const auto& value : json[recordings_key].toArray()) {
        Result<SessionRecording> recording = recordingFromJson(value.toObject(), folder);
        if (!recording) {
            return recording.error();
        }
        session.recordings.push_back(std::move(*recording));
    }
    for (const auto& value : json[sets_key].toArray()) {
        Result<SessionSet> set =
            setFromJson(value.toObject(), static_cast<int>(session.recordings.size()), folder);
        if (!set) {
            return set.error();
        }
        session.sets.push_back(std::move(*set));
    }
    session.current = placeFromJson(json[current_key], session.recordings.size());
    session.current_set = placeFromJson(json[current_set_key], session.sets.size());
    session.current_run = json[current_run_key].toInt(-1);
    session.dossier = {gyroFromJson(json[gyro_key].toObject()),
                       limitsFromJson(json[limits_key].toObject())};
    session.view = viewFromJson(json[view_key].toObject());
    session.unknown = json;
    for (const QString& known :
         {schema_key, program_key, settings_key, tolerance_key, live_key, recordings_key,
          current_key, sets_key, current_set_key, current_run_key, limits_key, view_key}) {
        session.unknown.remove(known);
    }
    QJsonObject gyro = json[gyro_key].toObject();
    for (const QString& known : {serial_key, type_key, operator_key, comment_key}) {
        gyro.remove(known);
    }
    session.unknown[gyro_key] = gyro;
    return session;
}

}  // namespace vybeg::ui
