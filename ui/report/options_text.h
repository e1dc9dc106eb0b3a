#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/settings.h"
#include "core/drift/drift_settings.h"

#include <QString>

namespace vybeg::ui {

// The settings that have a part in the result and are not the defaults, as options of the command
// line; empty: all are.

// Without algorithm, window, hop and carrier, which the table of analyses has.
QString optionsText(const Settings& settings);

// Settings in which the recordings differ have the value of each, with semicolons between them.
QString optionsText(const IdentifySettings& settings);

QString optionsText(const DriftSettings& settings);

}  // namespace vybeg::ui
