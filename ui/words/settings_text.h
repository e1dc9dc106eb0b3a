#pragma once

#include "core/analysis/settings.h"
#include "core/estimators/wave/estimator.h"

#include <QString>
#include <QStringList>

namespace vybeg::ui {

// Titles of the groups of the Analysis panel in which two settings differ.
QStringList changedGroups(const Settings& a, const Settings& b);

// In the interface's language: the algorithm's name with its number, e.g. "4 Demodulation", and a
// sentence about it.
QString algorithmText(Algorithm algorithm);
QString algorithmTip(Algorithm algorithm);

}  // namespace vybeg::ui
