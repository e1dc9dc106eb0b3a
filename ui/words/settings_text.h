#pragma once

#include "core/analysis/settings.h"

#include <QStringList>

namespace vybeg::ui {

// Titles of the groups of the Analysis panel in which two settings differ.
QStringList changedGroups(const Settings& a, const Settings& b);

}  // namespace vybeg::ui
