#pragma once

#include "core/base/result.h"
#include "ui/values/recording_set.h"

#include <QDir>
#include <QJsonObject>

namespace vybeg::ui {

// What a measurement list says of a set, as JSON, with its members by places in the session; paths
// below `folder` are relative to it.
QJsonObject listedToJson(const ListedSetBy<int>& listed, const QDir& folder);

// The reverse. Errors: setting_invalid.
Result<ListedSetBy<int>> listedFromJson(const QJsonObject& json, const QDir& folder);

// Relative below the folder of the session, so that both can be moved together.
QString storedPath(const QString& path, const QDir& folder);

}  // namespace vybeg::ui
