#pragma once

#include "core/recording/samples/recording.h"

#include <QCoreApplication>
#include <QString>

namespace vybeg::ui {

// Texts of context "Resonator", and a unit as core/ names it, in the interface's language.
struct ResonatorWords {
    Q_DECLARE_TR_FUNCTIONS(Resonator)
};
QString unitText(const char* unit);
QString withUnit(const QString& name, const QString& unit);

// The unit of both channels; empty where they have none, or two.
QString channelUnit(const Recording& recording);

}  // namespace vybeg::ui
