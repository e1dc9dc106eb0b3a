#include "ui/session/session.h"

#include "core/analysis/setting_table.h"
#include "core/drift/drift_settings.h"
#include "core/output/passport_json.h"
#include "ui/values/json_fields.h"
#include "ui/widgets/theme.h"
#include "ui/words/program_name.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace vybeg::ui {

namespace {

// Objects of a session. What a measurement list says of a set.
const QString columns_key = QStringLiteral("other_columns");
const QString members_key = QStringLiteral("members");
const QString by_panel_key = QStringLiteral("by_panel");
const QString place_key = QStringLiteral("recording");
const QString signal_key = QStringLiteral("signal");
const QString file_key = QStringLiteral("file");
const QString others_key = QStringLiteral("others");

// Recordings, analyses and sets.
const QString path_key = QStringLiteral("path");
const QString sha256_key = QStringLiteral("sha256");
const QString options_key = QStringLiteral("options");
const QString analyses_key = QStringLiteral("runs");
const QString color_key = QStringLiteral("color");
const QString name_key = QStringLiteral("name");
const QString model_key = QStringLiteral("model");
const QString listed_key = QStringLiteral("listed");
const QString result_key = QStringLiteral("result");
const QString up_to_date_key = QStringLiteral("result_up_to_date");

// The session itself.
const QString settings_key = QStringLiteral("settings");
const QString program_key = QStringLiteral("program");
const QString tolerance_key = QStringLiteral("tolerance");
const QString recordings_key = QStringLiteral("recordings");
const QString sets_key = QStringLiteral("sets");
const QString drift_key = QStringLiteral("drift");
const QString passport_key = QStringLiteral("passport");
const QString logs_key = QStringLiteral("logs");
const QString view_key = QStringLiteral("view");
const QString gyro_key = QStringLiteral("gyro");
const QString limits_key = QStringLiteral("limits");

template <class Archive, Described<AnalysisEntry> Owner>
void describe(Archive&& archive, Owner& analysis) {
    archive("name", analysis.shown.name);
    archive("place", analysis.place);
    archive.number("shade", analysis.shown.shade, curve_shades - 1);
    archive("visible", analysis.shown.visible);
    archive("live", analysis.live);
}

template <class Archive, Described<Session> Owner>
void describe(Archive&& archive, Owner& session) {
    archive("live", session.live);
    archive("current", session.current);
    archive("current_set", session.current_set);
    archive("current_run", session.current_analysis);
}

template <class Owner>
QStringList fieldsOf(const Owner& owner) {
    QJsonObject json;
    describe(JsonWriter(json), owner);
    return json.keys();
}

QString text(const std::string& utf8) {
    return QString::fromStdString(utf8);
}

// Relative below the folder of the session, so that both can be moved together.
QString storedPath(const QString& path, const QDir& folder) {
    const QString relative = folder.relativeFilePath(path);
    return relative.startsWith(QLatin1String("..")) ? path : relative;
}

QString pathFromJson(const QJsonObject& json, const QDir& folder) {
    return QDir::cleanPath(folder.absoluteFilePath(json[path_key].toString()));
}

// The unknown columns of a list, or their fields.
using Others = std::vector<std::pair<std::string, std::string>>;

QJsonArray textsToJson(const Others& others, std::string Others::value_type::*member) {
    return listToJson(others, [member](const auto& each) { return text(each.*member); });
}

Others othersFromJson(const QJsonArray& columns, const QJsonArray& fields) {
    Others others;
    for (qsizetype k = 0; k < std::min(columns.size(), fields.size()); ++k) {
        others.emplace_back(columns[k].toString().toStdString(),
                            fields[k].toString().toStdString());
    }
    return others;
}

// The place of a recording in a session; -1: none.
int placeOf(RecordingId id, const std::vector<ClosedRecording>& recordings) {
    const auto found = std::ranges::find(recordings, id, &ClosedRecording::id);
    return found == recordings.end() ? -1 : static_cast<int>(found - recordings.begin());
}

// The id that the recording at a place has in a session that is read; none: there is none.
RecordingId idAt(int place, std::size_t recordings) {
    return place >= 0 && place < static_cast<int>(recordings) ? static_cast<RecordingId>(place + 1)
                                                              : RecordingId::none;
}

QJsonObject rowToJson(int place, const RecordingRef& row, const SignalSettings& signal,
                      const QDir& folder) {
    IdentifySettings settings;
    settings.signal = signal;
    QJsonObject json{{place_key, place},
                     {signal_key, settingsToJson(identify_settings(), settings)},
                     {file_key, text(row.file)},
                     {path_key, storedPath(pathText(row), folder)},
                     {options_key, optionsToJson(row.open)},
                     {others_key, textsToJson(row.others, &Others::value_type::second)}};
    describe(JsonWriter(json), row.conditions);
    return json;
}

RecordingRef rowFromJson(const QJsonObject& json, const QJsonArray& columns, const QDir& folder) {
    RecordingRef row;
    row.file = json[file_key].toString().toStdString();
    row.path = pathFromJson(json, folder).toStdU16String();
    row.open = optionsFromJson(json[options_key].toObject());
    row.others = othersFromJson(columns, json[others_key].toArray());
    describe(JsonReader(json), row.conditions);
    return row;
}

// The rows of a list by the places of their recordings; those without one first, at negative
// places in their order.
QJsonObject listedToJson(const RecordingSet& set, const std::vector<ClosedRecording>& recordings,
                         const QDir& folder) {
    const MeasurementSet& listed = *set.listed;
    std::map<int, std::size_t> places;
    int without = -static_cast<int>(listed.recordings.size());
    for (std::size_t k = 0; k < listed.recordings.size(); ++k) {
        const int place = placeOf(static_cast<RecordingId>(listed.recordings[k].id), recordings);
        places.emplace(place < 0 ? without++ : place, k);
    }
    QJsonArray members;
    for (const auto& [place, k] : places) {
        members.append(
            rowToJson(place, listed.recordings[k], listed.settings.signal_of(k), folder));
    }
    const Others others =
        places.empty() ? Others() : listed.recordings[places.begin()->second].others;
    return {{settings_key, settingsToJson(identify_settings(), listed.settings)},
            {columns_key, textsToJson(others, &Others::value_type::first)},
            {by_panel_key, set.by_panel ? QJsonValue(true) : QJsonValue::Undefined},
            {members_key, members}};
}

Status readListed(const QJsonObject& json, std::size_t recordings, const QDir& folder,
                  RecordingSet& set) {
    MeasurementSet listed;
    auto settings = TRY(settingsFromJson(identify_settings(), json[settings_key].toObject()));
    listed.settings = std::move(settings);
    std::map<int, QJsonObject> rows;
    for (const auto& value : json[members_key].toArray()) {
        const QJsonObject row = value.toObject();
        rows.insert_or_assign(row[place_key].toInt(-1), row);
    }
    for (const auto& [place, row] : rows) {
        auto signal = TRY(settingsFromJson(identify_settings(), row[signal_key].toObject()));
        listed.settings.of_recordings.push_back(signal.signal);
        listed.recordings.push_back(rowFromJson(row, json[columns_key].toArray(), folder));
        listed.recordings.back().id = number(idAt(place, recordings));
    }
    set.listed = std::make_shared<const MeasurementSet>(std::move(listed));
    set.by_panel = json[by_panel_key].toBool();
    return {};
}

Result<Settings> analysisSettingsFromJson(const QJsonObject& json) {
    auto settings = TRY(settingsFromJson(analysis_settings(), json[settings_key].toObject()));
    TRY(validate(settings));
    return settings;
}

// One field of an identification, by the name of its row, as text.
QString identifyText(const char* name, const IdentifySettings& settings) {
    return text(row_named(identify_settings(), name)->text(settings));
}

Status readIdentify(const char* name, const QJsonValue& json, IdentifySettings& settings) {
    const std::string stored = json.toString().toStdString();
    return stored.empty() ? Status() : row_named(identify_settings(), name)->read(stored, settings);
}

QJsonObject analysisToJson(const AnalysisEntry& analysis) {
    QJsonObject json{{color_key, analysis.shown.color.name()},
                     {settings_key, settingsToJson(analysis_settings(), analysis.requested)}};
    describe(JsonWriter(json), analysis);
    return json;
}

Result<AnalysisEntry> analysisFromJson(const QJsonObject& json) {
    auto settings = TRY(analysisSettingsFromJson(json));
    AnalysisEntry analysis;
    analysis.requested = settings;
    analysis.shown.color = QColor(json[color_key].toString());
    analysis.place = 0;
    describe(JsonReader(json), analysis);
    return analysis;
}

QJsonObject recordingToJson(const ClosedRecording& recording, const QDir& folder) {
    QJsonObject json = recording.unknown;
    json[path_key] = storedPath(recording.path, folder);
    json[sha256_key] = recording.sha256;
    json[options_key] = optionsToJson(recording.options);
    json[analyses_key] =
        listToJson(recording.analyses.value_or(std::vector<AnalysisEntry>()), analysisToJson);
    return json;
}

Result<ClosedRecording> recordingFromJson(const QJsonObject& json, const QDir& folder) {
    ClosedRecording recording;
    recording.path = pathFromJson(json, folder);
    recording.sha256 = json[sha256_key].toString();
    recording.options = optionsFromJson(json[options_key].toObject());
    TRY(readList(json[analyses_key], recording.analyses.emplace(), analysisFromJson));
    recording.unknown = without(json, {path_key, sha256_key, options_key, analyses_key});
    return recording;
}

QJsonObject setToJson(const RecordingSet& set, const std::vector<ClosedRecording>& recordings,
                      const QDir& folder) {
    IdentifySettings model;
    model.model = set.model;
    QJsonObject json = set.unknown;
    json[name_key] = set.name;
    json[model_key] = identifyText("model", model);
    json[recordings_key] = listToJson(set.recordings, placeOf, recordings);
    if (set.listed) {
        json[listed_key] = listedToJson(set, recordings, folder);
    }
    if (set.kept) {
        json[result_key] = set.kept->json;
        json[up_to_date_key] = set.kept_up_to_date;
    }
    return json;
}

Result<RecordingSet> setFromJson(const QJsonObject& json, std::size_t recordings,
                                 const QDir& folder) {
    RecordingSet set;
    set.name = json[name_key].toString();
    for (const auto& value : json[recordings_key].toArray()) {
        const auto id = idAt(value.toInt(-1), recordings);
        if (id == RecordingId::none) {
            return refused_value("recordings", std::to_string(value.toInt(-1)),
                                 Phrase::tr("the session has no recording of this number"));
        }
        set.recordings.push_back(id);
    }
    IdentifySettings model;
    TRY(readIdentify("model", json[model_key], model));
    set.model = model.model;
    if (const QJsonValue listed = json[listed_key]; listed.isObject()) {
        TRY(readListed(listed.toObject(), recordings, folder, set));
    }
    if (const QJsonObject result = json[result_key].toObject(); !result.isEmpty()) {
        auto read = read_saved_result(QJsonDocument(result).toJson().toStdString());
        set.kept =
            std::make_shared<const SavedResult>(read ? SavedResult{std::move(*read), result, {}}
                                                     : SavedResult{{}, result, read.error()});
    }
    set.kept_up_to_date = json[up_to_date_key].toBool();
    set.unknown = without(
        json, {name_key, model_key, recordings_key, listed_key, result_key, up_to_date_key});
    return set;
}

QJsonObject fileToJson(const RecordingRef& file, const QDir& folder) {
    return {{path_key, storedPath(pathText(file), folder)}, {sha256_key, text(file.sha256)}};
}

RecordingRef fileFromJson(const QJsonObject& json, const QDir& folder) {
    RecordingRef file;
    file.path = pathFromJson(json, folder).toStdU16String();
    file.sha256 = json[sha256_key].toString().toStdString();
    return file;
}

// `json` has the keys of a later version, which stay.
QJsonObject driftToJson(const DriftInput& drift, QJsonObject json, const QDir& folder) {
    const QJsonArray logs = listToJson(drift.logs, fileToJson, folder);
    const QJsonObject settings = settingsToJson(drift_settings(), drift.settings);
    if (!logs.isEmpty() || !settings.isEmpty()) {
        json[logs_key] = logs;
        json[settings_key] = settings;
    }
    return json;
}

Result<DriftInput> driftFromJson(const QJsonObject& json, const QDir& folder) {
    auto settings = TRY(settingsFromJson(drift_settings(), json[settings_key].toObject()));
    DriftInput drift{{}, std::move(settings)};
    for (const auto& value : json[logs_key].toArray()) {
        drift.logs.push_back(fileFromJson(value.toObject(), folder));
    }
    return drift;
}

// Its file and the limit; `json` as above.
QJsonObject passportToJson(const PassportInput& passport, QJsonObject json, const QDir& folder) {
    if (!passport.file.path.empty()) {
        json[file_key] = fileToJson(passport.file, folder);
        describe(JsonWriter(json), passport);
    }
    return json;
}

PassportInput passportFromJson(const QJsonObject& json, const QDir& folder) {
    PassportInput passport;
    if (const QJsonObject file = json[file_key].toObject(); !file[path_key].toString().isEmpty()) {
        passport.file = fileFromJson(file, folder);
        describe(JsonReader(json), passport);
    }
    return passport;
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

// A place outside of its list is none.
void keepWithin(int& place, std::size_t count) {
    place = place >= 0 && place < static_cast<int>(count) ? place : -1;
}

}  // namespace

Session sessionOf(const Document& document, const TrackView& tracks) {
    Session session;
    session.settings = document.settings();
    session.tolerance = document.tolerance();
    session.dossier = document.dossier().dossier();
    session.live = document.live();
    for (const RecordingEntry& entry : document.recordings()) {
        session.recordings.push_back(asClosed(entry, document.analyses()));
    }
    if (const RecordingEntry* current = document.currentRecording()) {
        session.current = placeOf(current->id, session.recordings);
    }
    for (const RecordingSet& set : document.sets().all()) {
        if (document.sets().current() == &set) {
            session.current_set = static_cast<int>(session.sets.size());
        }
        // With its newest outcome, or otherwise what the session brought.
        RecordingSet& kept = session.sets.emplace_back(set);
        if (const auto found = document.sets().outcome(set)) {
            kept.kept = found;
            kept.kept_up_to_date = !document.sets().outOfDate(set, *found);
        }
    }
    session.drift = {document.drift().logs(), document.drift().settings()};
    session.passport = document.passport().input();
    const PlotContent content = tracks.content();
    session.view.zoom = content.zoom;
    session.view.variables = content.variables;
    session.view.units = content.units;
    session.view.cursors_s = {tracks.cursor(Cursor::a), tracks.cursor(Cursor::b)};
    return session;
}

std::vector<RecordingId> restoreSession(const Session& session, Document& document) {
    while (!document.recordings().empty()) {
        document.closeRecording(document.recordings().back().id);
    }
    while (!document.sets().all().empty()) {
        document.sets().remove(document.sets().all().back().id);
    }
    // Live analysis would compute what the session does not have.
    document.setLive(false);
    document.startWith(session.settings, session.tolerance);
    document.dossier().startWith(session.dossier);
    std::vector<RecordingId> ids;
    for (const ClosedRecording& recording : session.recordings) {
        ids.push_back(recording.path.isEmpty() ? RecordingId::none : document.restore(recording));
    }
    const auto id_of = [&](RecordingId id) {
        const int place = placeOf(id, session.recordings);
        return place < 0 ? RecordingId::none : ids[static_cast<std::size_t>(place)];
    };
    std::vector<RecordingSet> sets = session.sets;
    for (RecordingSet& set : sets) {
        set.name = set.name.trimmed();
        std::ranges::transform(set.recordings, set.recordings.begin(), id_of);
        std::erase(set.recordings, RecordingId::none);
        if (!set.listed) {
            continue;
        }
        MeasurementSet listed = *set.listed;
        for (RecordingRef& row : listed.recordings) {
            row.id = number(id_of(static_cast<RecordingId>(row.id)));
        }
        set.listed = std::make_shared<const MeasurementSet>(std::move(listed));
        // A recording that was missing when the session was saved is there again.
        for (const RecordingId id : set.recordings) {
            if (!rowOf(set, id)) {
                set.listed = std::make_shared<const MeasurementSet>(
                    withRowFor(*set.listed, document.recording(id)->path, id));
            }
        }
    }
    document.sets().restoreSets(std::move(sets));
    if (const auto& all = document.sets().all(); !all.empty()) {
        const auto last = static_cast<int>(all.size()) - 1;
        const int current = session.current_set >= 0 ? session.current_set : last;
        document.sets().setCurrent(all[static_cast<std::size_t>(current)].id);
    }
    document.drift().startWith(session.drift);
    document.passport().startWith(session.passport);
    document.undoStack().clear();  // of this session alone
    return ids;
}

QJsonObject sessionToJson(const Session& session, const QDir& folder) {
    IdentifySettings tolerance;
    tolerance.tolerance = session.tolerance;
    QJsonObject json = session.unknown;
    json[session_schema_key] = session_schema;
    json[program_key] = programName();
    json[settings_key] = settingsToJson(analysis_settings(), session.settings);
    json[tolerance_key] = identifyText("tolerance", tolerance);
    json[recordings_key] = listToJson(session.recordings, recordingToJson, folder);
    json[sets_key] = listToJson(session.sets, setToJson, session.recordings, folder);
    describe(JsonWriter(json), session);
    // Keys of a later version stay in the gyro's object of the unknown keys.
    QJsonObject gyro = json[gyro_key].toObject();
    describe(JsonWriter(gyro), session.dossier.gyro);
    json[gyro_key] = gyro;
    json[limits_key] = limitsToJson(session.dossier.limits);
    const auto put = [&json](const QString& key, const QJsonObject& value) {
        json.remove(key);
        if (!value.isEmpty()) {
            json[key] = value;
        }
    };
    put(drift_key, driftToJson(session.drift, json[drift_key].toObject(), folder));
    put(passport_key, passportToJson(session.passport, json[passport_key].toObject(), folder));
    json[view_key] = viewToJson(session.view);
    return json;
}

QString misplacedKey(const QJsonObject& json) {
    for (const QString& key :
         {settings_key, gyro_key, limits_key, drift_key, passport_key, view_key}) {
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
    auto settings = TRY(analysisSettingsFromJson(json));
    Session session;
    session.settings = settings;
    IdentifySettings tolerance;
    TRY(readIdentify("tolerance", json[tolerance_key], tolerance));
    session.tolerance = tolerance.tolerance;
    TRY(readList(json[recordings_key], session.recordings, recordingFromJson, folder));
    const std::size_t recordings = session.recordings.size();
    for (std::size_t place = 0; place < recordings; ++place) {
        session.recordings[place].id = idAt(static_cast<int>(place), recordings);
    }
    TRY(readList(json[sets_key], session.sets, setFromJson, recordings, folder));
    describe(JsonReader(json), session);
    keepWithin(session.current, session.recordings.size());
    keepWithin(session.current_set, session.sets.size());
    const QJsonObject gyro = json[gyro_key].toObject();
    describe(JsonReader(gyro), session.dossier.gyro);
    session.dossier.limits = limitsFromJson(json[limits_key].toObject());
    const QJsonObject drift = json[drift_key].toObject();
    session.drift = TRY(driftFromJson(drift, folder));
    const QJsonObject passport = json[passport_key].toObject();
    session.passport = passportFromJson(passport, folder);
    session.view = viewFromJson(json[view_key].toObject());
    session.unknown = without(without(json, fieldsOf(session)),
                              {session_schema_key, program_key, settings_key, tolerance_key,
                               recordings_key, sets_key, limits_key, view_key});
    session.unknown[gyro_key] = without(gyro, fieldsOf(session.dossier.gyro));
    session.unknown[drift_key] = without(drift, {logs_key, settings_key});
    session.unknown[passport_key] =
        without(without(passport, fieldsOf(session.passport)), {file_key});
    return session;
}

}  // namespace vybeg::ui
