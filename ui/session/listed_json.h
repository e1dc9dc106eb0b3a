#pragma once

#include "core/base/result.h"
#include "ui/values/recording_set.h"

#include <QDir>
#include <QJsonObject>

#include <functional>
#include <optional>

namespace vybeg::ui {

// What a measurement list says of a set, as JSON, with its members by whole numbers; paths below
// `folder` are relative to it.
QJsonObject listedToJson(const ListedSet& listed, const QDir& folder);

// The reverse. Errors: setting_invalid.
Result<ListedSet> listedFromJson(const QJsonObject& json, const QDir& folder);

// The same with other numbers of the members: `number` of each; negative ones for those without.
ListedSet renumbered(const ListedSet& listed, const std::function<std::optional<int>(int)>& number);

// Relative below the folder of the session, so that both can be moved together.
QString storedPath(const QString& path, const QDir& folder);

}  // namespace vybeg::ui
