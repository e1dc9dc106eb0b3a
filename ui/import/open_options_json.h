#pragma once

#include "core/recording/samples/open_options.h"

#include <QJsonObject>

namespace vybeg::ui {

// Options of opening as JSON, for a file or the settings; unset options are omitted.
QJsonObject optionsToJson(const OpenOptions& options);

// Reads the result of optionsToJson(); missing values and values of another type remain unset.
OpenOptions optionsFromJson(const QJsonObject& json);

}  // namespace vybeg::ui
