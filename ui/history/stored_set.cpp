#include "ui/history/stored_set.h"

#include "core/analysis/setting_table.h"
#include "ui/values/setting_json.h"

#include <QFileInfo>
#include <QJsonDocument>

namespace vybeg::ui {

StoredSet storedSet(const StoredResult& result, const IdentifySettings& otherwise) {
    StoredSet stored;
    MeasurementSet set;
    set.name = result.set;
    // Settings that differ between the recordings stand there side by side, in no option's form.
    const QJsonObject json =
        QJsonDocument::fromJson(QByteArray::fromStdString(result.json)).object();
    const QJsonObject settings = json[QStringLiteral("settings")].toObject();
    const Result<IdentifySettings> known = settingsFromJson(identify_settings(), settings);
    stored.settings_known = known && !settings.isEmpty();
    set.settings = stored.settings_known ? *known : otherwise;
    for (const StoredRecording& each : result.recordings) {
        const QString path = QString::fromStdString(each.path);
        if (!QFileInfo(path).isFile()) {
            stored.missing << path;
            continue;
        }
        ListedRecording row{each.file, path.toStdU16String(), {}, each.conditions, {}};
        row.open.channel_c = each.channel_c;
        row.open.channel_d = each.channel_d;
        if (stored.list.other_columns.empty()) {
            for (const auto& [column, value] : each.others) {
                stored.list.other_columns.push_back(column);
            }
        }
        for (const auto& [column, value] : each.others) {
            row.others.push_back(value);
        }
        set.recordings.push_back(std::move(row));
    }
    if (!set.recordings.empty()) {
        stored.list.sets.push_back(std::move(set));
    }
    return stored;
}

void tellGyroAndDate(MeasurementSet& set, const std::string& gyro, const std::string& date) {
    for (ListedRecording& recording : set.recordings) {
        recording.conditions.gyro = gyro;
        if (!date.empty()) {
            recording.conditions.date = date;
        }
    }
}

}  // namespace vybeg::ui
