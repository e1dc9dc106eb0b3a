#include "ui/session/listed_json.h"

#include "core/analysis/setting_table.h"
#include "ui/import/import_memory.h"
#include "ui/values/json_fields.h"

#include <QJsonArray>

#include <algorithm>
#include <utility>

namespace vybeg::ui {

namespace {

const QString listed_settings_key = QStringLiteral("settings");
const QString columns_key = QStringLiteral("other_columns");
const QString members_key = QStringLiteral("members");
const QString place_key = QStringLiteral("recording");
const QString signal_key = QStringLiteral("signal");
const QString file_key = QStringLiteral("file");
const QString listed_path_key = QStringLiteral("path");
const QString listed_options_key = QStringLiteral("options");
const QString others_key = QStringLiteral("others");

// The unknown columns of a list, or their fields.
using Others = std::vector<std::pair<std::string, std::string>>;
QJsonArray textsToJson(const Others& others, std::string Others::value_type::*member) {
    QJsonArray array;
    for (const auto& each : others) {
        array.append(QString::fromStdString(each.*member));
    }
    return array;
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
        {file_key, QString::fromStdString(row.file)},
        {listed_path_key, storedPath(QString::fromStdU16String(row.path.u16string()), folder)},
        {listed_options_key, optionsToJson(row.open)},
        {others_key, textsToJson(row.others, &Others::value_type::second)}};
    describe(JsonWriter(json), row.conditions);
    return json;
}

Result<ListedMember> memberFromJson(const QJsonObject& json, const QJsonArray& columns,
                                    const QDir& folder) {
    const Result<IdentifySettings> signal =
        settingsFromJson(identify_settings(), json[signal_key].toObject());
    if (!signal) {
        return signal.error();
    }
    ListedMember member;
    member.signal = signal->signal;
    RecordingRef& row = member.row;
    row.file = json[file_key].toString().toStdString();
    row.path =
        QDir::cleanPath(folder.absoluteFilePath(json[listed_path_key].toString())).toStdU16String();
    row.open = optionsFromJson(json[listed_options_key].toObject());
    row.others = othersFromJson(columns, json[others_key].toArray());
    describe(JsonReader(json), row.conditions);
    return member;
}

}  // namespace

QString storedPath(const QString& path, const QDir& folder) {
    const QString relative = folder.relativeFilePath(path);
    return relative.startsWith(QLatin1String("..")) ? path : relative;
}

QJsonObject listedToJson(const ListedSetBy<int>& listed, const QDir& folder) {
    QJsonArray members;
    for (const auto& [place, member] : listed.members) {
        members.append(memberToJson(place, member, folder));
    }
    const Others others =
        listed.members.empty() ? Others() : listed.members.begin()->second.row.others;
    return {{listed_settings_key, settingsToJson(identify_settings(), listed.settings)},
            {columns_key, textsToJson(others, &Others::value_type::first)},
            {members_key, members}};
}

Result<ListedSetBy<int>> listedFromJson(const QJsonObject& json, const QDir& folder) {
    auto settings =
        TRY(settingsFromJson(identify_settings(), json[listed_settings_key].toObject()));
    ListedSetBy<int> listed{std::move(settings), {}};
    const QJsonArray columns = json[columns_key].toArray();
    for (const auto& value : json[members_key].toArray()) {
        auto member = TRY(memberFromJson(value.toObject(), columns, folder));
        listed.members.insert_or_assign(value.toObject()[place_key].toInt(-1), std::move(member));
    }
    return listed;
}

}  // namespace vybeg::ui
