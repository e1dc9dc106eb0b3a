#pragma once

#include "ui/session/session.h"

#include <QJsonObject>

namespace vybeg::ui {

// What the plots of a session show. Values that are missing or out of their range keep their
// defaults.
QJsonObject viewToJson(const SessionView& view);
SessionView viewFromJson(const QJsonObject& json);

}  // namespace vybeg::ui
