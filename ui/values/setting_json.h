#pragma once

#include "core/base/setting_rows.h"

#include <QJsonObject>
#include <QString>

#include <vector>

namespace vybeg::ui {

// The settings that have a part in the result and differ from their defaults, by their names on the
// command line.
template <class S>
QJsonObject settingsToJson(const std::vector<SettingRow<S>>& rows, const S& settings) {
    const S defaults{};
    QJsonObject json;
    for (const SettingRow<S>& row : rows) {
        const std::string text = row.text(settings);
        if (row.has_part && text != row.text(defaults)) {
            json[QString::fromStdString(row.name)] = QString::fromStdString(text);
        }
    }
    return json;
}

// The reverse; missing settings keep their defaults. Errors: setting_invalid.
template <class S>
Result<S> settingsFromJson(const std::vector<SettingRow<S>>& rows, const QJsonObject& json) {
    S settings{};
    for (const SettingRow<S>& row : rows) {
        const QJsonValue value = json[QString::fromStdString(row.name)];
        if (row.has_part && value.isString()) {
            TRY(row.read(value.toString().toStdString(), settings));
        }
    }
    return settings;
}

}  // namespace vybeg::ui
