#include "ui/history/stored_set.h"

#include "core/analysis/setting_table.h"

#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace vybeg::ui {

namespace {

// The settings of each recording; those that differ stand side by side in one text.
std::optional<std::vector<IdentifySettings>> settingsOf(const StoredResult& result) {
    const QJsonObject json =
        QJsonDocument::fromJson(QByteArray::fromStdString(result.json)).object();
    const QJsonObject settings = json[QStringLiteral("settings")].toObject();
    const IdentifySettings defaults;
    std::vector<IdentifySettings> each(result.recordings.size());
    for (const SettingRow<IdentifySettings>& row : identify_settings()) {
        const QJsonValue value = settings[QString::fromStdString(row.name)];
        const QStringList parts = value.toString().split(QStringLiteral("; "));
        for (std::size_t k = 0; value.isString() && k < each.size(); ++k) {
            const bool differ = each.size() > 1 && parts.size() == std::ssize(each);
            const std::string text =
                (differ ? parts[static_cast<qsizetype>(k)] : value.toString()).toStdString();
            if (text != row.text(defaults) && !row.read(text, each[k])) {
                return std::nullopt;
            }
        }
    }
    return settings.isEmpty() ? std::nullopt : std::optional(std::move(each));
}

}  // namespace

StoredSet storedSet(const StoredResult& result, const IdentifySettings& otherwise) {
    StoredSet stored;
    MeasurementSet set;
    set.name = result.set;
    const auto settings = settingsOf(result);
    stored.settings_known = settings.has_value();
    set.settings = settings && !settings->empty() ? settings->front() : otherwise;
    for (std::size_t k = 0; k < result.recordings.size(); ++k) {
        const RecordingRef& each = result.recordings[k];
        const QString path = QString::fromStdU16String(each.path.u16string());
        if (!QFileInfo(path).isFile()) {
            stored.missing << path;
            continue;
        }
        set.recordings.push_back(each);
        set.settings.of_recordings.push_back(settings ? (*settings)[k].signal : otherwise.signal);
    }
    if (!set.recordings.empty()) {
        stored.list.sets.push_back(std::move(set));
    }
    return stored;
}

void tellGyroAndDate(MeasurementSet& set, const std::string& gyro, const std::string& date) {
    for (RecordingRef& recording : set.recordings) {
        recording.conditions.gyro = gyro;
        if (!date.empty()) {
            recording.conditions.date = date;
        }
    }
}

}  // namespace vybeg::ui
