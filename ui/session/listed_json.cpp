#include "ui/session/listed_json.h"

#include "core/analysis/setting_table.h"
#include "ui/import/open_options_json.h"
#include "ui/values/setting_json.h"

#include <QJsonArray>

#include <array>
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

struct TextCondition {
    const char* key;
    std::string Conditions::*member;
};

constexpr std::array text_conditions{TextCondition{"gyro", &Conditions::gyro},
                                     TextCondition{"date", &Conditions::date},
                                     TextCondition{"operator", &Conditions::operator_name},
                                     TextCondition{"comment", &Conditions::comment}};

struct NumberCondition {
    const char* key;
    std::optional<double> Conditions::*member;
};

constexpr std::array number_conditions{
    NumberCondition{"bias_v", &Conditions::bias_v},
    NumberCondition{"temperature_c", &Conditions::temperature_c}};

const QString exchanged_key = QStringLiteral("exchanged");

QJsonArray textsToJson(const std::vector<std::string>& texts) {
    QJsonArray array;
    for (const std::string& text : texts) {
        array.append(QString::fromStdString(text));
    }
    return array;
}

std::vector<std::string> textsFromJson(const QJsonValue& value) {
    std::vector<std::string> texts;
    for (const auto& each : value.toArray()) {
        texts.push_back(each.toString().toStdString());
    }
    return texts;
}

QJsonObject memberToJson(int place, const ListedMember& member, const QDir& folder) {
    IdentifySettings signal;
    signal.signal = member.signal;
    const ListedRecording& row = member.row;
    QJsonObject json{
        {place_key, place},
        {signal_key, settingsToJson(identify_settings(), signal)},
        {file_key, QString::fromStdString(row.file)},
        {listed_path_key, storedPath(QString::fromStdU16String(row.path.u16string()), folder)},
        {listed_options_key, optionsToJson(row.open)},
        {others_key, textsToJson(row.others)},
        {exchanged_key, row.conditions.exchanged}};
    for (const TextCondition& each : text_conditions) {
        json[QLatin1String(each.key)] = QString::fromStdString(row.conditions.*each.member);
    }
    for (const NumberCondition& each : number_conditions) {
        if (const auto& value = row.conditions.*each.member) {
            json[QLatin1String(each.key)] = *value;
        }
    }
    return json;
}

Result<ListedMember> memberFromJson(const QJsonObject& json, const QDir& folder) {
    const Result<IdentifySettings> signal =
        settingsFromJson(identify_settings(), json[signal_key].toObject());
    if (!signal) {
        return signal.error();
    }
    ListedMember member;
    member.signal = signal->signal;
    ListedRecording& row = member.row;
    row.file = json[file_key].toString().toStdString();
    row.path =
        QDir::cleanPath(folder.absoluteFilePath(json[listed_path_key].toString())).toStdU16String();
    row.open = optionsFromJson(json[listed_options_key].toObject());
    row.others = textsFromJson(json[others_key]);
    row.conditions.exchanged = json[exchanged_key].toBool();
    for (const TextCondition& each : text_conditions) {
        row.conditions.*each.member = json[QLatin1String(each.key)].toString().toStdString();
    }
    for (const NumberCondition& each : number_conditions) {
        if (const QJsonValue value = json[QLatin1String(each.key)]; value.isDouble()) {
            row.conditions.*each.member = value.toDouble();
        }
    }
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
    return {{listed_settings_key, settingsToJson(identify_settings(), listed.settings)},
            {columns_key, textsToJson(listed.other_columns)},
            {members_key, members}};
}

Result<ListedSetBy<int>> listedFromJson(const QJsonObject& json, const QDir& folder) {
    auto settings =
        TRY(settingsFromJson(identify_settings(), json[listed_settings_key].toObject()));
    ListedSetBy<int> listed{std::move(settings), textsFromJson(json[columns_key]), {}};
    for (const auto& value : json[members_key].toArray()) {
        auto member = TRY(memberFromJson(value.toObject(), folder));
        listed.members.insert_or_assign(value.toObject()[place_key].toInt(-1), std::move(member));
    }
    return listed;
}

}  // namespace vybeg::ui
