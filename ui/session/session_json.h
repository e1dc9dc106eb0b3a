#pragma once

#include "core/base/result.h"
#include "ui/session/session.h"
#include "ui/values/recording_set.h"

#include <QDir>
#include <QJsonObject>

namespace vybeg::ui {

// What the plots of a session show. Values that are missing or out of their range keep their
// defaults.
QJsonObject viewToJson(const SessionView& view);
SessionView viewFromJson(const QJsonObject& json);

// What a measurement list says of a set, as JSON, with its members by places in the session; paths
// below `folder` are relative to it.
QJsonObject listedToJson(const ListedSetBy<int>& listed, const QDir& folder);

// The reverse. Errors: setting_invalid.
Result<ListedSetBy<int>> listedFromJson(const QJsonObject& json, const QDir& folder);

// Relative below the folder of the session, so that both can be moved together.
QString storedPath(const QString& path, const QDir& folder);

inline constexpr int session_schema = 1;
inline const QString session_schema_key = QStringLiteral("vybeg_session");

// A session as the JSON object of its file; paths relative to `folder` where they lie below it.
QJsonObject sessionToJson(const Session& session, const QDir& folder);

// The first key whose value is not of the kind that a session has there; empty: none.
QString misplacedKey(const QJsonObject& json);

// The reverse. Values that are missing keep their defaults. Errors: setting_invalid, for a value
// that a setting does not take.
Result<Session> sessionFromJson(const QJsonObject& json, const QDir& folder);

}  // namespace vybeg::ui
