#pragma once

#include "core/recording/open/recording_preview.h"

#include <QString>

#include <optional>

namespace vybeg::ui {

// How files of a kind were imported last, kept in QSettings.

// What tells the kind of a file: for text its ending, the number of its columns and their names,
// as guessed; for raw samples (`raw`) and all others the ending.
QString importKind(const QString& path, const RecordingPreview& preview, bool raw);

std::optional<OpenOptions> rememberedImport(const QString& kind);

// The last 50 kinds are kept.
void rememberImport(const QString& kind, const OpenOptions& options);

}  // namespace vybeg::ui
