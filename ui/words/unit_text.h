#pragma once

#include <QString>

namespace vybeg::ui {

// A text of context "Resonator", and a unit as core/ names it, in the interface's language.
QString resonatorText(const char* text);
QString unitText(const char* unit);
QString withUnit(const QString& name, const QString& unit);

}  // namespace vybeg::ui
