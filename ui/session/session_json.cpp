#include "ui/session/session_json.h"

#include "core/analysis/setting_table.h"
#include "core/drift/drift_settings.h"
#include "ui/import/import_memory.h"
#include "ui/session/listed_json.h"
#include "ui/session/session_view_json.h"
#include "ui/values/json_fields.h"
#include "ui/widgets/theme.h"
#include "ui/words/program_name.h"

#include <QJsonArray>

#include <algorithm>
#include <utility>

namespace vybeg::ui {

namespace {

const QString program_key = QStringLiteral("program");
const QString settings_key = QStringLiteral("settings");
const QString tolerance_key = QStringLiteral("tolerance");
const QString live_key = QStringLiteral("live");
const QString recordings_key = QStringLiteral("recordings");
const QString current_key = QStringLiteral("current");
const QString sets_key = QStringLiteral("sets");
const QString current_set_key = QStringLiteral("current_set");
const QString current_analysis_key = QStringLiteral("current_run");
const QString listed_key = QStringLiteral("listed");
const QString result_key = QStringLiteral("result");
const QString up_to_date_key = QStringLiteral("result_up_to_date");
const QString drift_key = QStringLiteral("drift");
const QString logs_key = QStringLiteral("logs");
const QString view_key = QStringLiteral("view");
const QString gyro_key = QStringLiteral("gyro");
const QString limits_key = QStringLiteral("limits");
const QString path_key = QStringLiteral("path");
const QString sha256_key = QStringLiteral("sha256");
const QString options_key = QStringLiteral("options");
const QString analyses_key = QStringLiteral("runs");
const QString name_key = QStringLiteral("name");
const QString model_key = QStringLiteral("model");

QString text(const std::string& utf8) {
    return QString::fromStdString(utf8);
}

QJsonObject without(QJsonObject json, const QStringList& keys) {
    for (const QString& key : keys) {
        json.remove(key);
    }
    return json;
}

Result<Settings> analysisSettingsFromJson(const QJsonObject& json) {
    Result<Settings> settings = settingsFromJson(analysis_settings(), json);
    if (settings) {
        TRY(validate(*settings));
    }
    return settings;
}

// One field of an identification, by the name of its row.
const SettingRow<IdentifySettings>& identifyRow(const std::string& name) {
    return *std::ranges::find(identify_settings(), name, &SettingRow<IdentifySettings>::name);
}

QJsonObject wishToJson(const AnalysisWish& analysis) {
    return {{QStringLiteral("name"), analysis.name},
            {QStringLiteral("place"), analysis.place},
            {QStringLiteral("color"), analysis.color.name()},
            {QStringLiteral("shade"), analysis.shade},
            {QStringLiteral("visible"), analysis.visible},
            {QStringLiteral("live"), analysis.live},
            {settings_key, settingsToJson(analysis_settings(), analysis.settings)}};
}

Result<AnalysisWish> wishFromJson(const QJsonObject& json) {
    const auto settings = TRY(analysisSettingsFromJson(json[settings_key].toObject()));
    AnalysisWish analysis;
    analysis.settings = settings;
    analysis.name = json[QStringLiteral("name")].toString();
    analysis.place = json[QStringLiteral("place")].toInt();
    analysis.color = QColor(json[QStringLiteral("color")].toString());
    analysis.shade = std::clamp(json[QStringLiteral("shade")].toInt(), 0, curve_shades - 1);
    analysis.visible = json[QStringLiteral("visible")].toBool(true);
    analysis.live = json[live_key].toBool();
    return analysis;
}

QJsonObject recordingToJson(const SessionRecording& recording, const QDir& folder) {
    QJsonArray analyses;
    for (const AnalysisWish& analysis : recording.analyses) {
        analyses.append(wishToJson(analysis));
    }
    QJsonObject json = recording.unknown;
    json[path_key] = storedPath(recording.path, folder);
    json[sha256_key] = recording.sha256;
    json[options_key] = optionsToJson(recording.options);
    json[analyses_key] = analyses;
    return json;
}

Result<SessionRecording> recordingFromJson(const QJsonObject& json, const QDir& folder) {
    SessionRecording recording;
    recording.path = QDir::cleanPath(folder.absoluteFilePath(json[path_key].toString()));
    recording.sha256 = json[sha256_key].toString();
    recording.options = optionsFromJson(json[options_key].toObject());
    for (const auto& value : json[analyses_key].toArray()) {
        auto analysis = TRY(wishFromJson(value.toObject()));
        recording.analyses.push_back(std::move(analysis));
    }
    recording.unknown = without(json, {path_key, sha256_key, options_key, analyses_key});
    return recording;
}

QJsonObject setToJson(const SessionSet& set, const QDir& folder) {
    QJsonArray members;
    for (const int place : set.recordings) {
        members.append(place);
    }
    IdentifySettings model;
    model.model = set.model;
    QJsonObject json = set.unknown;
    json[name_key] = set.name;
    json[model_key] = text(identifyRow("model").text(model));
    json[recordings_key] = members;
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
    set.name = json[name_key].toString();
    for (const auto& value : json[recordings_key].toArray()) {
        if (const int place = value.toInt(-1); place >= 0 && place < recordings) {
            set.recordings.push_back(place);
        }
    }
    IdentifySettings model;
    if (const QString word = json[model_key].toString(); !word.isEmpty()) {
        TRY(identifyRow("model").read(word.toStdString(), model));
    }
    set.model = model.model;
    if (const QJsonValue listed = json[listed_key]; listed.isObject()) {
        auto read = TRY(listedFromJson(listed.toObject(), folder));
        set.listed = std::move(read);
    }
    set.result = {json[result_key].toObject(), json[up_to_date_key].toBool()};
    set.unknown = without(
        json, {name_key, model_key, recordings_key, listed_key, result_key, up_to_date_key});
    return set;
}

// `json` has the keys of a later version, which stay.
QJsonObject driftToJson(const DriftInput& drift, QJsonObject json, const QDir& folder) {
    QJsonArray logs;
    for (const DriftLog& log : drift.logs) {
        logs.append(
            QJsonObject{{path_key, storedPath(log.path, folder)}, {sha256_key, log.sha256}});
    }
    const QJsonObject settings = settingsToJson(drift_settings(), drift.settings);
    if (!logs.isEmpty() || !settings.isEmpty()) {
        json[logs_key] = logs;
        json[settings_key] = settings;
    }
    return json;
}

Result<DriftInput> driftFromJson(const QJsonObject& json, const QDir& folder) {
    DriftInput drift;
    auto settings = TRY(settingsFromJson(drift_settings(), json[settings_key].toObject()));
    drift.settings = std::move(settings);
    for (const auto& value : json[logs_key].toArray()) {
        const QJsonObject log = value.toObject();
        drift.logs.push_back({QDir::cleanPath(folder.absoluteFilePath(log[path_key].toString())),
                              log[sha256_key].toString()});
    }
    return drift;
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

bool isListOfObjects(const QJsonValue& value) {
    const QJsonArray elements = value.toArray();
    return value.isArray() && std::all_of(elements.begin(), elements.end(),
                                          [](const auto& element) { return element.isObject(); });
}

// A place in a list, -1 for one outside of it.
int placeFromJson(const QJsonValue& value, std::size_t count) {
    const int place = value.toInt(-1);
    return place >= 0 && place < static_cast<int>(count) ? place : -1;
}

}  // namespace

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
    json[session_schema_key] = session_schema;
    json[program_key] = programName();
    json[settings_key] = settingsToJson(analysis_settings(), session.settings);
    json[tolerance_key] = text(identifyRow("tolerance").text(tolerance));
    json[live_key] = session.live;
    json[recordings_key] = recordings;
    json[current_key] = session.current;
    json[sets_key] = sets;
    json[current_set_key] = session.current_set;
    json[current_analysis_key] = session.current_analysis;
    // Keys of a later version stay in the gyro's object of the unknown keys.
    QJsonObject gyro = json[gyro_key].toObject();
    describe(JsonWriter(gyro), session.dossier.gyro);
    json[gyro_key] = gyro;
    json[limits_key] = limitsToJson(session.dossier.limits);
    const QJsonObject drift = driftToJson(session.drift, json[drift_key].toObject(), folder);
    json.remove(drift_key);
    if (!drift.isEmpty()) {
        json[drift_key] = drift;
    }
    json[view_key] = viewToJson(session.view);
    return json;
}

QString misplacedKey(const QJsonObject& json) {
    for (const QString& key : {settings_key, gyro_key, limits_key, drift_key, view_key}) {
        if (json.contains(key) && !json[key].isObject()) {
            return key;
        }
    }
    for (const QString& key : {recordings_key, sets_key}) {
        if (json.contains(key) && !isListOfObjects(json[key])) {
            return key;
        }
    }
    const QJsonObject drift = json[drift_key].toObject();
    return drift.contains(logs_key) && !isListOfObjects(drift[logs_key]) ? drift_key : QString();
}

Result<Session> sessionFromJson(const QJsonObject& json, const QDir& folder) {
    Session session;
    const auto settings = TRY(analysisSettingsFromJson(json[settings_key].toObject()));
    session.settings = settings;
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
        auto recording = TRY(recordingFromJson(value.toObject(), folder));
        session.recordings.push_back(std::move(recording));
    }
    for (const auto& value : json[sets_key].toArray()) {
        auto set =
            TRY(setFromJson(value.toObject(), static_cast<int>(session.recordings.size()), folder));
        session.sets.push_back(std::move(set));
    }
    session.current = placeFromJson(json[current_key], session.recordings.size());
    session.current_set = placeFromJson(json[current_set_key], session.sets.size());
    session.current_analysis = json[current_analysis_key].toInt(-1);
    const QJsonObject gyro = json[gyro_key].toObject();
    describe(JsonReader(gyro), session.dossier.gyro);
    session.dossier.limits = limitsFromJson(json[limits_key].toObject());
    const QJsonObject drift = json[drift_key].toObject();
    auto read_drift = TRY(driftFromJson(drift, folder));
    session.drift = std::move(read_drift);
    session.view = viewFromJson(json[view_key].toObject());
    session.unknown = without(json, {session_schema_key, program_key, settings_key, tolerance_key,
                                     live_key, recordings_key, current_key, sets_key,
                                     current_set_key, current_analysis_key, limits_key, view_key});
    QJsonObject known;
    describe(JsonWriter(known), session.dossier.gyro);
    session.unknown[gyro_key] = without(gyro, known.keys());
    session.unknown[drift_key] = without(drift, {logs_key, settings_key});
    return session;
}

}  // namespace vybeg::ui
