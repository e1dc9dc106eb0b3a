#pragma once

#include "core/recording/open/preview.h"
#include "core/recording/samples/open_options.h"

#include <QJsonObject>
#include <QString>

#include <optional>

namespace vybeg::ui {

// Options of opening as JSON, for a file or the settings; unset options are omitted.
QJsonObject optionsToJson(const OpenOptions& options);

// Reads the result of optionsToJson(); missing values and values of another type remain unset.
OpenOptions optionsFromJson(const QJsonObject& json);

// Last import options of each kind of file, stored in QSettings.

// Key of a kind of file: for text the ending, the number of columns and their guessed names; for
// raw samples (`raw`) and all others the ending.
QString importKind(const QString& path, const RecordingPreview& preview, bool raw);

std::optional<OpenOptions> rememberedImport(const QString& kind);

// Stores the options; keeps the last 50 kinds.
void rememberImport(const QString& kind, const OpenOptions& options);

}  // namespace vybeg::ui
