#pragma once

#include "core/recording/samples/recording.h"

#include <QString>

namespace vybeg::ui {

// A text of context "Resonator", and a unit as core/ names it, in the interface's language.
QString resonatorText(const char* text);
QString unitText(const char* unit);
QString withUnit(const QString& name, const QString& unit);

// The unit of both channels; empty where they have none, or two.
QString channelUnit(const Recording& recording);

}  // namespace vybeg::ui
