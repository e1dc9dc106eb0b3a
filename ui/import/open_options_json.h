#pragma once

#include "core/recording/samples/open_options.h"

#include <QJsonObject>

namespace vybeg::ui {

// How a recording is opened, to be kept in a file or the settings; what is not said is left out.
QJsonObject optionsToJson(const OpenOptions& options);

// Reads what optionsToJson() has written; what is missing or of another type is not said.
OpenOptions optionsFromJson(const QJsonObject& json);

}  // namespace vybeg::ui
