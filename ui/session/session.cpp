#include "ui/session/session.h"

#include "core/analysis/setting_table.h"
#include "core/drift/drift_settings.h"
#include "ui/values/json_fields.h"
#include "ui/widgets/theme.h"
#include "ui/words/program_name.h"

#include <QJsonArray>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace vybeg::ui {

namespace {

// Objects of a session. A view's ranges, variables and cursors.
const QString time_key = QStringLiteral("time_s");
const QString values_key = QStringLiteral("values");
const QString variables_key = QStringLiteral("variables");
const QString cursors_key = QStringLiteral("cursors_s");

// What a measurement list says of a set.
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
const QString logs_key = QStringLiteral("logs");
const QString view_key = QStringLiteral("view");
const QString gyro_key = QStringLiteral("gyro");
const QString limits_key = QStringLiteral("limits");

template <class Archive, Described<SessionView> Owner>
void describe(Archive&& archive, Owner& view) {
    // As TrendKind.
    constexpr std::array<const char*, trend_kinds> trends{"line", "beat"};
    archive("page", view.page);
    archive.word("trend", view.trend, trends);
    archive("units", view.units);
}

template <class Archive, Described<AnalysisWish> Owner>
void describe(Archive&& archive, Owner& analysis) {
    archive("name", analysis.name);
    archive("place", analysis.place);
    archive.number("shade", analysis.shade, curve_shades - 1);
    archive("visible", analysis.visible);
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

QJsonObject without(QJsonObject json, const QStringList& keys) {
    for (const QString& key : keys) {
        json.remove(key);
    }
    return json;
}

template <class Each, class ToJson, class... Args>
QJsonArray listToJson(const std::vector<Each>& all, const ToJson& to_json, const Args&... args) {
    QJsonArray list;
    for (const Each& each : all) {
        list.append(to_json(each, args...));
    }
    return list;
}

template <class Each, class FromJson, class... Args>
Status readList(const QJsonValue& list, std::vector<Each>& all, const FromJson& from_json,
                const Args&... args) {
    for (const auto& value : list.toArray()) {
        auto each = TRY(from_json(value.toObject(), args...));
        all.push_back(std::move(each));
    }
    return {};
}

// Relative below the folder of the session, so that both can be moved together.
QString storedPath(const QString& path, const QDir& folder) {
    const QString relative = folder.relativeFilePath(path);
    return relative.startsWith(QLatin1String("..")) ? path : relative;
}

QString pathFromJson(const QJsonObject& json, const QDir& folder) {
    return QDir::cleanPath(folder.absoluteFilePath(json[path_key].toString()));
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

QJsonObject memberToJson(int place, const ListedMember& member, const QDir& folder) {
    IdentifySettings signal;
    signal.signal = member.signal;
    const RecordingRef& row = member.row;
    QJsonObject json{
        {place_key, place},
        {signal_key, settingsToJson(identify_settings(), signal)},
        {file_key, text(row.file)},
        {path_key, storedPath(QString::fromStdU16String(row.path.u16string()), folder)},
        {options_key, optionsToJson(row.open)},
        {others_key, textsToJson(row.others, &Others::value_type::second)}};
    describe(JsonWriter(json), row.conditions);
    return json;
}

Result<ListedMember> memberFromJson(const QJsonObject& json, const QJsonArray& columns,
                                    const QDir& folder) {
    const auto signal = TRY(settingsFromJson(identify_settings(), json[signal_key].toObject()));
    ListedMember member;
    member.signal = signal.signal;
    RecordingRef& row = member.row;
    row.file = json[file_key].toString().toStdString();
    row.path = pathFromJson(json, folder).toStdU16String();
    row.open = optionsFromJson(json[options_key].toObject());
    row.others = othersFromJson(columns, json[others_key].toArray());
    describe(JsonReader(json), row.conditions);
    return member;
}

// Members by places in the session.
QJsonObject listedToJson(const ListedSetBy<int>& listed, const QDir& folder) {
    QJsonArray members;
    for (const auto& [place, member] : listed.members) {
        members.append(memberToJson(place, member, folder));
    }
    const Others others =
        listed.members.empty() ? Others() : listed.members.begin()->second.row.others;
    return {{settings_key, settingsToJson(identify_settings(), listed.settings)},
            {columns_key, textsToJson(others, &Others::value_type::first)},
            {by_panel_key, listed.by_panel ? QJsonValue(true) : QJsonValue::Undefined},
            {members_key, members}};
}

Result<ListedSetBy<int>> listedFromJson(const QJsonObject& json, const QDir& folder) {
    auto settings = TRY(settingsFromJson(identify_settings(), json[settings_key].toObject()));
    ListedSetBy<int> listed{std::move(settings), {}, json[by_panel_key].toBool()};
    const QJsonArray columns = json[columns_key].toArray();
    for (const auto& value : json[members_key].toArray()) {
        auto member = TRY(memberFromJson(value.toObject(), columns, folder));
        listed.members.insert_or_assign(value.toObject()[place_key].toInt(-1), std::move(member));
    }
    return listed;
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

QJsonObject wishToJson(const AnalysisWish& analysis) {
    QJsonObject json{{color_key, analysis.color.name()},
                     {settings_key, settingsToJson(analysis_settings(), analysis.settings)}};
    describe(JsonWriter(json), analysis);
    return json;
}

Result<AnalysisWish> wishFromJson(const QJsonObject& json) {
    auto settings = TRY(analysisSettingsFromJson(json));
    AnalysisWish analysis;
    analysis.settings = std::move(settings);
    analysis.color = QColor(json[color_key].toString());
    describe(JsonReader(json), analysis);
    return analysis;
}

QJsonObject recordingToJson(const SessionRecording& recording, const QDir& folder) {
    QJsonObject json = recording.unknown;
    json[path_key] = storedPath(recording.path, folder);
    json[sha256_key] = recording.sha256;
    json[options_key] = optionsToJson(recording.options);
    json[analyses_key] = listToJson(recording.analyses, wishToJson);
    return json;
}

Result<SessionRecording> recordingFromJson(const QJsonObject& json, const QDir& folder) {
    SessionRecording recording;
    recording.path = pathFromJson(json, folder);
    recording.sha256 = json[sha256_key].toString();
    recording.options = optionsFromJson(json[options_key].toObject());
    TRY(readList(json[analyses_key], recording.analyses, wishFromJson));
    recording.unknown = without(json, {path_key, sha256_key, options_key, analyses_key});
    return recording;
}

QJsonObject setToJson(const SessionSet& set, const QDir& folder) {
    IdentifySettings model;
    model.model = set.model;
    QJsonObject json = set.unknown;
    json[name_key] = set.name;
    json[model_key] = identifyText("model", model);
    json[recordings_key] = listToJson(set.recordings, [](int place) { return place; });
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
    TRY(readIdentify("model", json[model_key], model));
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
    const QJsonArray logs = listToJson(drift.logs, [&folder](const DriftLog& log) {
        return QJsonObject{{path_key, storedPath(log.path, folder)}, {sha256_key, log.sha256}};
    });
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
        const QJsonObject log = value.toObject();
        drift.logs.push_back({pathFromJson(log, folder), log[sha256_key].toString()});
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

// A place outside of its list is none.
void keepWithin(int& place, std::size_t count) {
    place = place >= 0 && place < static_cast<int>(count) ? place : -1;
}

int placeOf(const std::vector<RecordingEntry>& recordings, RecordingId id) {
    const auto found = std::ranges::find(recordings, id, &RecordingEntry::id);
    return found == recordings.end() ? -1 : static_cast<int>(found - recordings.begin());
}

// The same by other keys of the members: `key` of each; negative ones for those without.
template <class Key, class Before>
ListedSetBy<Key> renamed(const ListedSetBy<Before>& listed,
                         const std::function<std::optional<Key>(Before)>& key) {
    ListedSetBy<Key> other{listed.settings, {}, listed.by_panel};
    int without = -static_cast<int>(listed.members.size());  // rows of logs keep their order
    for (const auto& [before, member] : listed.members) {
        other.members.emplace(key(before).value_or(static_cast<Key>(without++)), member);
    }
    return other;
}

}  // namespace

Session sessionOf(const Document& document, const TrackView& tracks) {
    Session session;
    session.settings = document.settings();
    session.tolerance = document.tolerance();
    session.dossier = document.dossier().dossier();
    session.live = document.live();
    for (const RecordingEntry& entry : document.recordings()) {
        session.recordings.push_back(
            {entry.path, entry.sha256, entry.options, wishesOf(document.analyses(), entry.id), {}});
    }
    if (const RecordingEntry* current = document.currentRecording()) {
        session.current = placeOf(document.recordings(), current->id);
    }
    for (const RecordingSet& set : document.sets().all()) {
        SessionSet stored{set.name, {}, set.model, {}, document.sets().kept(set), {}};
        for (const RecordingId id : set.recordings) {
            stored.recordings.push_back(placeOf(document.recordings(), id));
        }
        if (set.listed) {
            stored.listed = renamed<int, RecordingId>(*set.listed, [&](RecordingId id) {
                const int place = placeOf(document.recordings(), id);
                return place < 0 ? std::nullopt : std::optional(place);
            });
        }
        if (document.sets().current() == &set) {
            session.current_set = static_cast<int>(session.sets.size());
        }
        session.sets.push_back(std::move(stored));
    }
    session.drift = {document.drift().logs(), document.drift().settings()};
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
    for (const SessionRecording& recording : session.recordings) {
        ids.push_back(recording.path.isEmpty() ? RecordingId::none
                                               : document.restore(recording.path, recording.options,
                                                                  recording.analyses));
    }
    std::vector<SetId> set_ids;
    for (const SessionSet& set : session.sets) {
        std::vector<RecordingId> members;
        for (const int place : set.recordings) {
            if (const auto id = ids[static_cast<std::size_t>(place)]; id != RecordingId::none) {
                members.push_back(id);
            }
        }
        set_ids.push_back(document.sets().add(members));
        document.sets().rename(set_ids.back(), set.name);
        document.sets().setModel(set_ids.back(), set.model);
        if (set.listed) {
            ListedSet listed = renamed<RecordingId, int>(*set.listed, [&](int place) {
                const auto known = place >= 0 && place < static_cast<int>(ids.size());
                const auto id = known ? ids[static_cast<std::size_t>(place)] : RecordingId::none;
                return id == RecordingId::none ? std::nullopt : std::optional(id);
            });
            // A recording that was missing when the session was saved is there again.
            for (const RecordingId id : members) {
                if (!listed.members.contains(id)) {
                    listed = withRowFor(listed, document.recording(id)->path, id);
                }
            }
            document.sets().setListed(set_ids.back(), std::move(listed));
        }
    }
    for (std::size_t place = 0; place < set_ids.size(); ++place) {
        document.sets().setKept(set_ids[place], session.sets[place].result);
    }
    if (session.current_set >= 0) {
        document.sets().setCurrent(set_ids[static_cast<std::size_t>(session.current_set)]);
    }
    document.drift().startWith(session.drift);
    document.undoStack().clear();  // of this session alone
    return ids;
}

void restoreView(const SessionView& view, TrackView& tracks) {
    if (!view.variables.empty()) {
        tracks.setShownVariables(view.variables);
    }
    tracks.setZoom(view.zoom);
    tracks.setCursor(Cursor::a, view.cursors_s[0]);
    tracks.setCursor(Cursor::b, view.cursors_s[1]);
}

QJsonObject viewToJson(const SessionView& view) {
    QJsonObject values;
    for (const auto& [variable, range] : view.zoom.fixed) {
        values[columnOf(variable)] = rangeToJson(range);
    }
    QJsonArray cursors;
    for (const auto& cursor : view.cursors_s) {
        cursors.append(cursor ? QJsonValue(*cursor) : QJsonValue());
    }
    QJsonObject json{{time_key, rangeToJson(view.zoom.time)},
                     {values_key, values},
                     {variables_key, listToJson(view.variables, columnOf)},
                     {cursors_key, cursors}};
    describe(JsonWriter(json), view);
    return json;
}

SessionView viewFromJson(const QJsonObject& json) {
    SessionView view;
    describe(JsonReader(json), view);
    if (const auto time = rangeFromJson(json[time_key])) {
        view.zoom.time = *time;
    }
    const QJsonObject values = json[values_key].toObject();
    for (const SlowVariable variable : all_slow_variables) {
        if (const auto range = rangeFromJson(values[columnOf(variable)])) {
            view.zoom.fixed.emplace(variable, *range);
        }
    }
    for (const auto& column : json[variables_key].toArray()) {
        const auto found = std::ranges::find(all_slow_variables, column.toString(), columnOf);
        if (found != all_slow_variables.end()) {
            view.variables.push_back(*found);
        }
    }
    const QJsonArray cursors = json[cursors_key].toArray();
    for (int which = 0; which < 2; ++which) {
        if (cursors.at(which).isDouble()) {
            view.cursors_s[static_cast<std::size_t>(which)] = cursors.at(which).toDouble();
        }
    }
    return view;
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
    json[sets_key] = listToJson(session.sets, setToJson, folder);
    describe(JsonWriter(json), session);
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
    auto settings = TRY(analysisSettingsFromJson(json));
    Session session;
    session.settings = std::move(settings);
    IdentifySettings tolerance;
    TRY(readIdentify("tolerance", json[tolerance_key], tolerance));
    session.tolerance = tolerance.tolerance;
    TRY(readList(json[recordings_key], session.recordings, recordingFromJson, folder));
    const auto recordings = static_cast<int>(session.recordings.size());
    TRY(readList(json[sets_key], session.sets, setFromJson, recordings, folder));
    describe(JsonReader(json), session);
    keepWithin(session.current, session.recordings.size());
    keepWithin(session.current_set, session.sets.size());
    const QJsonObject gyro = json[gyro_key].toObject();
    describe(JsonReader(gyro), session.dossier.gyro);
    session.dossier.limits = limitsFromJson(json[limits_key].toObject());
    const QJsonObject drift = json[drift_key].toObject();
    auto read_drift = TRY(driftFromJson(drift, folder));
    session.drift = std::move(read_drift);
    session.view = viewFromJson(json[view_key].toObject());
    session.unknown = without(without(json, fieldsOf(session)),
                              {session_schema_key, program_key, settings_key, tolerance_key,
                               recordings_key, sets_key, limits_key, view_key});
    session.unknown[gyro_key] = without(gyro, fieldsOf(session.dossier.gyro));
    session.unknown[drift_key] = without(drift, {logs_key, settings_key});
    return session;
}

}  // namespace vybeg::ui
