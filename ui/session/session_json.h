#pragma once

#include "core/base/result.h"
#include "ui/session/session.h"

#include <QDir>
#include <QJsonObject>

namespace vybeg::ui {

// What the plots of a session show. Values that are missing or out of their range keep their
// defaults.
QJsonObject viewToJson(const SessionView& view);
SessionView viewFromJson(const QJsonObject& json);

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
